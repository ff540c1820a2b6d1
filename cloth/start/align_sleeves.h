// Sleeves turned to the arms that they are to go around.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Turns sleeves in `placed` to run down their arms, for a sleeve that starts beside its arm closes
/// beside it. Only sleeves turn that are farther off than patterns laid out for about this pose.
/// The seams between a sleeve's panels tell its direction. It is compared with the arm's over the
/// length of those seams. Sleeves without such seams stay, and so do panels that the skeleton
/// positioned.
/// Each panel turns about the middle of the armhole, at its own depth. So front and back keep
/// facing each other and what they are sewn to.
/// Returns radians, for each arm whose sleeve turned.
std::map<BodyPart, double> turn_sleeves(const PanelMesh& garment,
                                        const std::vector<BodyPart>& part_of_point,
                                        const Skeleton& skeleton, std::vector<Vec3>& placed);

}  // namespace toile
