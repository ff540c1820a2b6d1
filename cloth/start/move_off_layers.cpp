#include "cloth/start/move_off_layers.h"

#include <span>

#include "cloth/start/constants.h"
#include "cloth/start/facing.h"

namespace toile {

namespace {

/// The direction that a panel's right side faces on the whole, a unit vector; zero when the panel
/// is rolled.
Vec3 facing(const PanelMesh& garment, const MeshedPanel& panel, const std::vector<Vec3>& placed) {
  const FacingSum sum = facing_of(
      std::span(garment.triangles).subspan(panel.first_triangle, panel.triangles), placed);
  return sum.flatter_than(facing_flatness) ? Vec3(sum.vectors.normalized()) : Vec3::Zero();
}

}  // namespace

void move_off_layers(const PanelMesh& garment, const DistanceGrid& collider, Placement& placement) {
  for (const MeshedPanel& panel : garment.panels) {
    const Vec3 direction = facing(garment, panel, placement.placed);
    if (direction == Vec3::Zero()) continue;
    const auto too_close = [&](int steps) {
      int count = 0;
      for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
        count +=
            collider.at(placement.placed[p] + steps * layer_clearing_step * direction).distance <
            layer_start_clearance;
      }
      return count;
    };
    int fewest = too_close(0);
    int best = 0;
    for (int steps = 1; steps <= max_layer_clearing_steps && fewest > 0; ++steps) {
      const int count = too_close(steps);
      if (count >= fewest) continue;
      fewest = count;
      best = steps;
    }
    if (best == 0) continue;
    placement.moved_off_layers[panel.name] = best * layer_clearing_step;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      placement.placed[p] += best * layer_clearing_step * direction;
    }
  }
  placement.points_inside = points_inside(placement.placed, collider);
}

}  // namespace toile
