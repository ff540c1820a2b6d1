#include "cloth/start/clear_of_layers.h"

#include <Eigen/Geometry>

namespace toile {

namespace {

constexpr double step = 0.01;  // metres
constexpr int max_steps = 40;
/// Metres from the collider that a point starts at least.
constexpr double clearance = 0.01;
/// A panel faces some way when its areas, added as vectors, keep this share of their sum.
constexpr double flat_share = 0.5;

/// The way a panel's right side faces on the whole, of unit length; zero when it is rolled.
Vec3 facing(const PanelMesh& garment, const MeshedPanel& panel, const std::vector<Vec3>& placed) {
  Vec3 sum = Vec3::Zero();
  double areas = 0;
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    const Triangle& corners = garment.triangles[t];
    const Vec3 area =
        (placed[corners[1]] - placed[corners[0]]).cross(placed[corners[2]] - placed[corners[0]]);
    sum += area;
    areas += area.norm();
  }
  return sum.norm() > flat_share * areas ? Vec3(sum.normalized()) : Vec3::Zero();
}

}  // namespace

void clear_of_layers(const PanelMesh& garment, const DistanceGrid& collider, Placement& placement) {
  for (const MeshedPanel& panel : garment.panels) {
    const Vec3 way = facing(garment, panel, placement.placed);
    if (way == Vec3::Zero()) continue;
    const auto too_close = [&](int steps) {
      int count = 0;
      for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
        count += collider.at(placement.placed[p] + steps * step * way).distance < clearance;
      }
      return count;
    };
    int fewest = too_close(0);
    int best = 0;
    for (int steps = 1; steps <= max_steps && fewest > 0; ++steps) {
      const int count = too_close(steps);
      if (count >= fewest) continue;
      fewest = count;
      best = steps;
    }
    if (best == 0) continue;
    placement.moved_off_layers[panel.name] = best * step;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      placement.placed[p] += best * step * way;
    }
  }
  placement.points_inside = 0;
  for (const Vec3& p : placement.placed) placement.points_inside += collider.at(p).distance < 0;
}

}  // namespace toile
