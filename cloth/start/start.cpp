#include "cloth/start/start.h"

#include <utility>

#include "cloth/scene/collider.h"
#include "cloth/start/centre_legs.h"
#include "cloth/start/move_off_layers.h"
#include "cloth/start/positioning.h"
#include "cloth/start/resolve_intersections.h"

namespace toile {

namespace {

void make_clear(const PanelMesh& garment, const Scene& scene, Placement& placement) {
  const DistanceGrid& distance = scene.collider->grid();
  if (has_layers(scene)) move_off_layers(garment, distance, placement);
  resolve_intersections(garment, scene.collider->surface(), distance, scene.skeleton, placement);
}

}  // namespace

Placement find_start(const PanelMesh& garment, const Scene& scene, double hang) {
  const DistanceGrid& distance = scene.collider->grid();
  Positioning positioning = position_panels(garment, distance, scene.skeleton);
  PanelMesh positioned = garment;
  positioned.placed = positioning.placed;
  if (scene.skeleton != nullptr) centre_legs(garment, *scene.skeleton, positioned.placed);
  Placement placement =
      turn_and_lift(positioned, distance, scene.skeleton, hang, &scene.collider->body());
  const std::vector<Vec3> before = placement.placed;
  make_clear(garment, scene, placement);
  if (!placement.moved_clear.empty()) {
    for (std::size_t p = 0; p < before.size(); ++p) {
      positioned.placed[p] += placement.placed[p] - before[p];
    }
    Placement again =
        turn_and_lift(positioned, distance, scene.skeleton, hang, &scene.collider->body());
    again.moved_off_layers = placement.moved_off_layers;
    again.moved_clear = placement.moved_clear;
    placement = std::move(again);
    make_clear(garment, scene, placement);
  }
  placement.positioned = std::move(positioning.panels);
  placement.initial = std::move(positioning.placed);
  return placement;
}

}  // namespace toile
