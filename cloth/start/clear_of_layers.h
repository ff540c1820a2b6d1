// Where a further layer starts: clear of the layers below, too.
#pragma once

#include "cloth/start/draw_and_lift.h"
#include "geometry/distance_grid.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Moves each panel that starts inside the collider, or closer to it than 1 cm, as a whole the way
/// its right side faces, in steps of 1 cm up to 40 cm: to the first place where none of its points
/// is, else to where the fewest are. A rolled panel, which faces no way, stays. A pattern places
/// its panels around the body; under a further layer the body is wider than it knew.
/// Notes the moves in `placement` and counts its points_inside anew.
void clear_of_layers(const PanelMesh& garment, const DistanceGrid& collider, Placement& placement);

}  // namespace toile
