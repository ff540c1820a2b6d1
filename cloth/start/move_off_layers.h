// Where a further layer starts: clear of the layers below, too.
#pragma once

#include "cloth/start/turn_and_lift.h"
#include "geometry/distance_grid.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Moves panels off the layers below. A pattern places its panels around the body; with layers on,
/// the body is wider than the pattern knew.
/// A panel moves as a whole if any of its points is inside the collider or within 1 cm of it. It
/// moves in the direction that its right side faces, in steps of 1 cm, up to 40 cm. It stops where
/// no such point is left, or else where the fewest are. A rolled panel faces no direction, and
/// stays. Notes the moves in `placement` and counts its points_inside again.
void move_off_layers(const PanelMesh& garment, const DistanceGrid& collider, Placement& placement);

}  // namespace toile
