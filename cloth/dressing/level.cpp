#include "cloth/dressing/level.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cloth/dressing/constants.h"
#include "cloth/model/nested_meshes.h"
#include "cloth/scene/collider.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// Metres that nodes keep from a surface of curves down to the radius `tightest_curve`. The faces
/// between nodes cut off the sagitta of such a curve. At least `asked`, at most `most`.
double clearing_offset(double asked, double edge_length, double tightest_curve, double most) {
  const double needed = face_clearance + edge_length * edge_length / (8 * tightest_curve);
  return std::max(asked, std::min(needed, most));
}

}  // namespace

std::vector<PanelMesh> nested_meshes(const PanelMesh& garment) {
  std::vector<PanelMesh> meshes = {garment};
  while (meshes.back().subdivisions > 0) meshes.push_back(coarsen(meshes.back()));
  return meshes;
}

double resting_offset(const PanelMesh& garment, const Scene& scene) {
  return clearing_offset(body_offset_of(scene, garment), garment.edge_length, body_curve_radius,
                         max_body_offset);
}

double settling_offset(const PanelMesh& mesh, int depth, const Scene& scene,
                       double resting_offset) {
  const double offset = resting_offset * (1 + offset_growth * depth);
  if (!has_layers(scene)) return offset;
  return std::max(offset, clearing_offset(0, mesh.edge_length, fold_curve_radius, max_fold_offset));
}

Level compiled_level(const PanelMesh& mesh, int depth, const Scene& scene,
                     const std::vector<Vec3>& placed, double resting_offset) {
  const double offset = settling_offset(mesh, depth, scene, resting_offset);
  return {&mesh, depth, placed, compile(mesh, scene, placed, offset)};
}

Level finer_level(const Level& coarse, const PanelMesh& fine, const Scene& scene,
                  double resting_offset, State& state) {
  Level level = compiled_level(fine, coarse.depth - 1, scene,
                               refine_placed(*coarse.mesh, coarse.placed, fine), resting_offset);
  state.nodes = refine_positions(*coarse.mesh, coarse.model.node_of_point, state.nodes, fine,
                                 level.model.node_of_point, level.model.nodes);
  std::vector<LimitMultiplier> finer;
  for (const LimitMultiplier& multiplier : state.warm_start.multipliers) {
    finer.insert(finer.end(), 4, multiplier);
  }
  state.warm_start.multipliers = std::move(finer);
  return level;
}

bool is_clear_of_itself(const Level& level, const State& state) {
  return count_self_intersections(level, state) == 0;
}

std::size_t count_self_intersections(const Level& level, const State& state) {
  return self_intersections({state.nodes, level.model.node_triangles}).size();
}

std::vector<TrianglePair> body_intersections(const Level& level, const State& state) {
  return intersections({state.nodes, level.model.node_triangles},
                       level.model.scene.collider->body());
}

bool is_clear_of_layers(const Level& level, const State& state) {
  // Metres: what is a little inside by the smoothed distance may be outside by the exact one.
  const Scene& scene = level.model.scene;
  if (!has_layers(scene)) return false;
  for (const Vec3& p : state.nodes) {
    if (scene.collider->grid().at(p).distance < max_smooth_depth) return false;
  }
  return intersections({state.nodes, level.model.node_triangles}, scene.collider->cloth()).empty();
}

double fallen(const Level& level, const State& state, const std::vector<Vec3>& from) {
  const auto middle = [](const std::vector<Vec3>& points) {
    const Vec3 sum = std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero()));
    return Vec3(sum / static_cast<double>(points.size()));
  };
  const Vec3 path = middle(state.nodes) - middle(from);
  return path.dot(level.model.scene.gravity.normalized());
}

std::vector<Vec3> points_of(const Level& level, const State& state) {
  return point_positions(level.model, state.nodes);
}

}  // namespace toile
