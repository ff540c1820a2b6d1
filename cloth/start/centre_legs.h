// Trousers moved sideways, so that each leg lies between the seams of its panels.
#pragma once

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Moves the panels of a leg sideways where a seam between front and back stands on the wrong side
/// of the bones. An inner seam outside of them would close through the leg or beside it, and so
/// would an outer one inside. All panels of the leg move as one, until that seam is
/// `leg_seam_clearance` beside the bones. They stay where the seams on the other side would come
/// nearer to the bones than that.
///
/// Moves points of `placed` (metres, per material point) only. Without hips nothing is moved.
/// Linear in the points.
void centre_legs(const PanelMesh& garment, const Skeleton& skeleton, std::vector<Vec3>& placed);

}  // namespace toile
