// Sleeves turned to the arms that they are to go around.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Turns the panels of a sleeve in `placed` to run down the arm, where they are off it by more than
/// patterns are that were laid out for about this pose: a sleeve that starts beside its arm closes
/// beside it. Which way a sleeve runs the seams between its panels tell, over whose length the arm
/// is looked at; one without such seams stays, as do panels that the skeleton positioned. Each
/// panel turns about the middle of the armhole, at its own depth: so front and back keep facing
/// each other, and what they are sewn to. Radians turned by, for each arm whose sleeve was.
std::map<std::string, double> turn_sleeves(const PanelMesh& garment,
                                           const std::vector<std::string>& part_of_point,
                                           const Skeleton& skeleton, std::vector<Vec3>& placed);

}  // namespace toile
