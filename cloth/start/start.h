// The start of a garment: from the panels of the pattern to the first state.
#pragma once

#include "cloth/scene/scene.h"
#include "cloth/start/turn_and_lift.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Places the panels on the scene's body, which it must have: position_panels() and centre_legs()
/// once, then turn_and_lift(), move_off_layers() where there are layers, and
/// resolve_intersections(). Panels that had to be moved are turned and lifted again from where they
/// came to stand. `hang` as in turn_and_lift(). Throws what those throw.
Placement find_start(const PanelMesh& garment, const Scene& scene, double hang = 0);

}  // namespace toile
