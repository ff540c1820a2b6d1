#include "geometry/surface_morph.h"

#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <queue>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/half_edges.h"
#include "geometry/laplacian.h"

namespace toile {

namespace {

using Eigen::Matrix3d;
using Sparse = Eigen::SparseMatrix<double>;

/// Two edges of a triangle and its normal, as columns; its length is that of the edges.
Matrix3d frame_of(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.points[t[1]] - mesh.points[t[0]];
  const Vec3 b = mesh.points[t[2]] - mesh.points[t[0]];
  const Vec3 normal = a.cross(b);
  Matrix3d frame;
  frame << a, b, normal / std::sqrt(std::max(normal.norm(), 1e-300));
  return frame;
}

Eigen::Quaterniond turn_by(const Vec3& rotation) {
  const double angle = rotation.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation / angle));
}

/// The rotation vector of the same turn that is nearest to `near`.
Vec3 unwrapped(const Vec3& rotation, const Vec3& near) {
  const double angle = rotation.norm();
  // A turn of nothing may be a whole turn about any axis.
  const Vec3 axis = angle > 0 ? Vec3(rotation / angle) : near.stableNormalized();
  const double turns = std::round((near.dot(axis) - angle) / (2 * std::numbers::pi));
  return (angle + 2 * std::numbers::pi * turns) * axis;
}

/// Per triangle its neighbours across edges; -1 for none.
std::vector<std::array<int, 3>> neighbours_of(const TriangleMesh& mesh) {
  std::vector<std::array<int, 3>> neighbours(mesh.triangles.size(), {-1, -1, -1});
  const std::vector<HalfEdge> sides = half_edges(mesh.triangles, mesh.points.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (!sides[i].same_edge(sides[i + 1])) continue;
    neighbours[sides[i].triangle][sides[i].opposite] = sides[i + 1].triangle;
    neighbours[sides[i + 1].triangle][sides[i + 1].opposite] = sides[i].triangle;
  }
  return neighbours;
}

}  // namespace

struct SurfaceMorph::Parts {
  struct Change {
    Vec3 rotation = Vec3::Zero();             ///< radians along the axis
    Matrix3d stretch = Matrix3d::Identity();  ///< before the rotation
  };

  TriangleMesh from, to;
  std::vector<Change> changes;                 // per triangle
  std::vector<std::array<double, 3>> weights;  // per triangle, of the edge opposite to each corner
  std::vector<int> held;  // points that go straight: one of each part, and loose ones
  Eigen::SimplicialLDLT<Sparse> solver;

  void find_changes();
  void unwrap_and_anchor();
  void factorise(const std::string& name);
};

void SurfaceMorph::Parts::find_changes() {
  changes.resize(from.triangles.size());
  for (std::size_t t = 0; t < changes.size(); ++t) {
    const Matrix3d before = frame_of(from, from.triangles[t]);
    const Matrix3d gradient = frame_of(to, to.triangles[t]) * before.inverse();
    if (!gradient.allFinite()) continue;
    const Eigen::JacobiSVD<Matrix3d> svd(gradient, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
    if (!(turn.determinant() > 0)) continue;
    const Eigen::AngleAxisd about(turn);
    changes[t].rotation = about.angle() * about.axis();
    changes[t].stretch = turn.transpose() * gradient;
  }
}

void SurfaceMorph::Parts::unwrap_and_anchor() {
  const std::vector<std::array<int, 3>> neighbours = neighbours_of(from);
  std::vector<int> by_angle(changes.size());
  std::iota(by_angle.begin(), by_angle.end(), 0);
  std::ranges::stable_sort(by_angle, {}, [&](int t) { return changes[t].rotation.norm(); });
  std::vector<bool> is_reached(changes.size(), false);
  // Neighbours whose turns differ least come first, so a fold turns nothing behind it the wrong
  // way.
  using Step = std::tuple<double, int, int>;  // the difference, a triangle, and where it comes from
  std::priority_queue<Step, std::vector<Step>, std::greater<>> front;
  const auto reach = [&](int triangle) {
    is_reached[triangle] = true;
    const Vec3& here = changes[triangle].rotation;
    for (const int next : neighbours[triangle]) {
      if (next < 0 || is_reached[next]) continue;
      front.emplace((unwrapped(changes[next].rotation, here) - here).norm(), next, triangle);
    }
  };
  for (const int seed : by_angle) {
    if (is_reached[seed]) continue;
    held.push_back(from.triangles[seed][0]);
    reach(seed);
    while (!front.empty()) {
      const auto [difference, triangle, before] = front.top();
      front.pop();
      if (is_reached[triangle]) continue;
      changes[triangle].rotation = unwrapped(changes[triangle].rotation, changes[before].rotation);
      reach(triangle);
    }
  }
}

void SurfaceMorph::Parts::factorise(const std::string& name) {
  Sparse system = cotangent_laplacian(from);
  const auto n = static_cast<Eigen::Index>(from.points.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    if (system.coeff(i, i) == 0) held.push_back(static_cast<int>(i));
  }
  std::vector<Eigen::Triplet<double>> ones;
  for (const int point : held) ones.emplace_back(point, point, 1.0);
  Sparse at_held(n, n);
  at_held.setFromTriplets(ones.begin(), ones.end());
  solver.compute(system + at_held);
  if (solver.info() != Eigen::Success) {
    throw Error(name, "the way between its shapes can't be solved for", "let clean-body repair it");
  }
}

SurfaceMorph::SurfaceMorph(const TriangleMesh& from, const TriangleMesh& to,
                           const std::string& name) {
  if (from.points.size() != to.points.size() || from.triangles != to.triangles) {
    throw Error(name, "has other triangles than the posed body",
                "give the body from which it was posed, as pose-body read it");
  }
  auto parts = std::make_unique<Parts>();
  parts->from = from;
  parts->to = to;
  for (const Triangle& t : from.triangles) {
    parts->weights.push_back(cotangent_weights(from, t));
  }
  parts->find_changes();
  parts->unwrap_and_anchor();
  parts->factorise(name);
  parts_ = std::move(parts);
}

SurfaceMorph::~SurfaceMorph() = default;
SurfaceMorph::SurfaceMorph(SurfaceMorph&&) noexcept = default;

Eigen::Quaterniond SurfaceMorph::turn(int triangle, double share) const {
  return turn_by(share * parts_->changes[triangle].rotation);
}

TriangleMesh SurfaceMorph::at(double share) const {
  const TriangleMesh& from = parts_->from;
  const TriangleMesh& to = parts_->to;
  if (share <= 0) return from;
  if (share >= 1) return to;
  Eigen::MatrixX3d pull = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(from.points.size()), 3);
  for (std::size_t t = 0; t < from.triangles.size(); ++t) {
    const Parts::Change& change = parts_->changes[t];
    const Matrix3d gradient = turn_by(share * change.rotation) *
                              ((1 - share) * Matrix3d::Identity() + share * change.stretch);
    for (int c = 0; c < 3; ++c) {
      const int i = from.triangles[t][(c + 1) % 3];
      const int j = from.triangles[t][(c + 2) % 3];
      const Vec3 edge = parts_->weights[t][c] * (gradient * (from.points[j] - from.points[i]));
      pull.row(j) += edge;
      pull.row(i) -= edge;
    }
  }
  const auto straight = [&](int point) {
    return Vec3((1 - share) * from.points[point] + share * to.points[point]);
  };
  for (const int point : parts_->held) pull.row(point) += straight(point);
  const Eigen::MatrixX3d solved = parts_->solver.solve(pull);
  TriangleMesh between{{}, from.triangles};
  between.points.reserve(from.points.size());
  for (Eigen::Index i = 0; i < solved.rows(); ++i) between.points.emplace_back(solved.row(i));
  return between;
}

}  // namespace toile
