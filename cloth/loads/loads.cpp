#include "cloth/loads/loads.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "cloth/contact/pair_forces.h"
#include "cloth/loads/inner_face.h"
#include "cloth/model/bending_matrix.h"
#include "cloth/model/stretch.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// What a triangle's weft, warp and their cross have become in space.
struct Deformed {
  Vec3 weft;
  Vec3 warp;
};

Deformed deformed(const StretchTriangle& s, const Triangle& n, const std::vector<Vec3>& x) {
  return {s.weft[0] * x[n[0]] + s.weft[1] * x[n[1]] + s.weft[2] * x[n[2]],
          s.warp[0] * x[n[0]] + s.warp[1] * x[n[1]] + s.warp[2] * x[n[2]]};
}

/// N/m: the tension of a triangle as worn, of the energy that stretch_forces() has.
Eigen::Matrix3d tension_of(const StretchTriangle& s, const Deformed& at) {
  const double weft = at.weft.norm();
  const double warp = at.warp.norm();
  const double widened = at.weft.cross(at.warp).norm();
  if (!(weft > 0) || !(warp > 0) || !(widened > 0)) return Eigen::Matrix3d::Zero();
  const double shear = s.shear_stiffness * at.weft.dot(at.warp);
  const Eigen::Matrix3d across = at.weft * at.warp.transpose();
  return (s.weft_stiffness * (weft - 1) / weft * at.weft * at.weft.transpose() +
          s.warp_stiffness * (warp - 1) / warp * at.warp * at.warp.transpose() +
          shear * (across + across.transpose())) /
         (s.area * widened);
}

TriangleLoad load_of(const StretchTriangle& s, const Triangle& corners,
                     const std::vector<Vec3>& x) {
  const Deformed at = deformed(s, corners, x);
  TriangleLoad load;
  load.tension = tension_of(s, at);
  if (!(at.weft.norm() > 0) || !(at.warp.norm() > 0)) return load;
  const Vec3 weft = at.weft.normalized();
  const Vec3 warp = at.warp.normalized();
  const Vec3 beside = (warp - weft.dot(warp) * weft).normalized();
  Eigen::Matrix2d in_plane;
  in_plane << weft.dot(load.tension * weft), weft.dot(load.tension * beside),
      beside.dot(load.tension * weft), beside.dot(load.tension * beside);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(in_plane);
  load.tension_least = principal.eigenvalues()[0];
  load.tension_most = principal.eigenvalues()[1];
  const Vec2 most = principal.eigenvectors().col(1);
  load.direction = most.x() * weft + most.y() * beside;
  // The yarns of a gathered row lie in folds that the mesh does not have.
  if (!s.limited) return load;
  load.strain_weft = at.weft.norm() - 1;
  load.strain_warp = at.warp.norm() - 1;
  load.strain_bias =
      std::max((at.weft + at.warp).norm(), (at.weft - at.warp).norm()) / std::numbers::sqrt2 - 1;
  load.warp = warp;
  load.tension_weft = weft.dot(load.tension * weft);
  load.tension_warp = warp.dot(load.tension * warp);
  return load;
}

/// The cloth's own forces (N) on each node: all but those of skin and floor.
class OwnForces {
 public:
  OwnForces(const GarmentModel& model, const std::vector<Vec3>& nodes)
      : model_(model), nodes_(nodes), forces_(nodes.size(), Vec3::Zero()) {
    for (std::size_t n = 0; n < forces_.size(); ++n) {
      forces_[n] = model_.mass[n] * model_.scene.gravity;
    }
    bend();
    push();
  }

  /// With the pull of the triangles, and the elastics as long as `length(a, b)` of their nodes.
  template <typename Length>
  std::vector<Vec3> with(const std::vector<StretchTriangle>& stretch, const Length& length) const {
    std::vector<Vec3> forces = forces_;
    for (std::size_t t = 0; t < stretch.size(); ++t) {
      const Triangle& n = model_.node_triangles[t];
      const auto pull = stretch_forces(stretch[t], {}, nodes_[n[0]], nodes_[n[1]], nodes_[n[2]]);
      for (int i = 0; i < 3; ++i) forces[n[i]] += pull[i];
    }
    for (const ElasticSegment& segment : model_.elastics) {
      const int a = model_.node_of_point[segment.points[0]];
      const int b = model_.node_of_point[segment.points[1]];
      const Vec3 pull =
          elastic_tension(segment, length(a, b)) * (nodes_[b] - nodes_[a]).normalized();
      forces[a] += pull;
      forces[b] -= pull;
    }
    return forces;
  }

 private:
  void bend() {
    if (model_.bend.empty()) return;
    const BendRows rows = bend_matrix(model_, model_.node_of_point, nodes_.size(), false).inside;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      for (int i = rows.first[n]; i < rows.first[n + 1]; ++i) {
        forces_[n] += rows.stiffness[i] * (nodes_[rows.vertex[i]] - nodes_[n]);
      }
    }
  }

  /// Of cloth on cloth.
  void push() {
    if (!model_.scene.self_contact) return;
    std::vector<int> node(nodes_.size());
    std::iota(node.begin(), node.end(), 0);
    const ProximitySearch search(model_.node_triangles, node, model_.shortest_edge);
    std::vector<ContactPair> pairs;
    std::vector<double> bound;
    search.find(nodes_, model_.self_gap, model_.self_gap, pairs, bound, false);
    for (const ContactPair& pair : pairs) {
      std::array<Vec3, 4> at;
      for (int i = 0; i < 4; ++i) at[i] = nodes_[pair.vertices[i]];
      const PairPush push = push_of(pair, at, true);
      for (int i = 0; i < 4; ++i) forces_[pair.vertices[i]] += push.on[i];
    }
  }

  const GarmentModel& model_;
  const std::vector<Vec3>& nodes_;
  std::vector<Vec3> forces_;  // of weight, bending and cloth on cloth
};

}  // namespace

double TriangleLoad::grain_from_plumb() const {
  return std::acos(std::min(1.0, std::abs(warp.y()))) * 180 / std::numbers::pi;
}

Loads measure_loads(const GarmentModel& model, const std::vector<Vec3>& nodes,
                    const SurfaceDistance& skin, double touching) {
  const InnerFace inner(model, nodes, skin, touching);
  Loads loads;
  std::vector<StretchTriangle> stretch(model.stretch.size());
  loads.triangles.resize(model.stretch.size());
  parallel_for_chunks(stretch.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const int triangle = static_cast<int>(t);
      stretch[t] = inner.pulling(triangle);
      loads.triangles[t] = load_of(inner.strained(triangle), model.node_triangles[t], nodes);
      loads.triangles[t].area = inner.area(triangle);
    }
  });
  loads.nodes.resize(nodes.size());
  for (std::size_t t = 0; t < stretch.size(); ++t) {
    for (const int n : model.node_triangles[t]) {
      loads.nodes[n].area += loads.triangles[t].area / 3;
    }
  }
  const OwnForces own(model, nodes);
  const std::vector<Vec3> of_middle =
      own.with(model.stretch, [&](int a, int b) { return (nodes[a] - nodes[b]).norm(); });
  const std::vector<Vec3> of_inner =
      own.with(stretch, [&](int a, int b) { return inner.length(a, b); });
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    loads.weight += model.mass[n] * model.scene.gravity.norm();
    NodeLoad& load = loads.nodes[n];
    load.touches = inner.touches(static_cast<int>(n));
    if (!load.touches) {
      loads.unexplained += of_middle[n].norm();
      continue;
    }
    load.force = -of_middle[n];
    loads.of_skin += load.force;
    if (!(load.area > 0)) continue;
    const Vec3& outward = inner.outward(static_cast<int>(n));
    load.pressure = std::max(-outward.dot(of_inner[n]), 0.0) / load.area;
    load.friction = (load.force - outward.dot(load.force) * outward).norm() / load.area;
  }
  return loads;
}

}  // namespace toile
