#include "geometry/body/skin_weights.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "geometry/error.h"

namespace toile {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Bounds of the weights of needles and of obtuse corners. They keep the weights of the bones in
/// [0, 1]. Sound triangles are far from both, so half or double of them change little.
constexpr double min_cotangent = 1e-3;
constexpr double max_cotangent = 10;

/// The cotangent Laplacian.
Sparse laplacian(const TriangleMesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      const int i = t[(c + 1) % 3];
      const int j = t[(c + 2) % 3];
      const Vec3 a = mesh.points[i] - mesh.points[t[c]];
      const Vec3 b = mesh.points[j] - mesh.points[t[c]];
      const double area = a.cross(b).norm();
      const double cotangent = area > 0 ? a.dot(b) / area : 0;
      const double weight = std::clamp(cotangent / 2, min_cotangent, max_cotangent);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
    }
  }
  const auto n = static_cast<Eigen::Index>(mesh.points.size());
  Sparse result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

SkinWeights skin_weights(const TriangleMesh& body, const std::vector<int>& cores) {
  const auto n = static_cast<Eigen::Index>(body.points.size());
  SkinWeights weights = SkinWeights::Zero(n, bone_count);
  std::vector<int> row_of(body.points.size(), -1);
  int free = 0;
  for (std::size_t i = 0; i < cores.size(); ++i) {
    if (cores[i] == SkinCores::no_bone) {
      row_of[i] = free++;
    } else {
      weights(static_cast<Eigen::Index>(i), cores[i]) = 1;
    }
  }
  if (free == 0) return weights;

  const Sparse energy = laplacian(body);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd known = Eigen::MatrixXd::Zero(free, bone_count);
  for (int column = 0; column < energy.outerSize(); ++column) {
    for (Sparse::InnerIterator at(energy, column); at; ++at) {
      const int row = row_of[at.row()];
      if (row < 0) continue;
      if (row_of[column] >= 0) {
        entries.emplace_back(row, row_of[column], at.value());
      } else {
        known(row, cores[column]) -= at.value();
      }
    }
  }
  Sparse system(free, free);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> solver(system);
  if (solver.info() != Eigen::Success) {
    throw Error("skin", "the weights of the bones can't be solved for", "let clean-body repair it");
  }
  const Eigen::MatrixXd found = solver.solve(known);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (row_of[i] < 0) continue;
    const Eigen::ArrayXd harmonic = found.row(row_of[i]).array().max(0).min(1);
    const Eigen::RowVectorXd smooth = (harmonic.square() * (3 - 2 * harmonic)).matrix();
    const double sum = smooth.sum();
    if (!(sum > 0)) {
      throw Error("skin", "a part of it hangs on no bone", "let clean-body remove it");
    }
    weights.row(i) = smooth / sum;
  }
  return weights;
}

}  // namespace toile
