// Panels of a leg, kept on its side of the body.
#pragma once

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Draws panels of trousers together that reach past the plane between the legs, such as a wide
/// flounce at a cuff. Flounces of both legs that start across each other would close around both
/// legs. Each such panel is scaled square to the plane, about the middle of what it is sewn to,
/// until it keeps `leg_panel_gap` from the plane. The cloth regains its width as it settles.
///
/// Moves points of `placed` (metres, per material point) only. Without hips nothing is moved.
/// Linear in the points, and for each such panel in the seam points.
void narrow_leg_panels(const PanelMesh& garment, const Skeleton& skeleton,
                       std::vector<Vec3>& placed);

}  // namespace toile
