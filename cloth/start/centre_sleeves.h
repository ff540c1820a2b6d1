// Sleeves moved square to their arms, so that their seams close around them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Moves the sleeves in `placed` so that their arms lie between the seams that close around them. A
/// tapered sleeve often stands some centimetres under its arm. Its outer seam would then close
/// through the arm.
///
/// All panels of an arm move as one, in the plane of front and back. They turn by up to 20 degrees
/// about the armhole, and shift by up to 15 cm square to the arm. Seams count whose sides stand
/// before and behind the arm. They should keep 1.5 cm from the outline of the arm. The move wins
/// that leaves the least of them nearer, and of equal ones the smallest. Panels that the skeleton
/// positioned stay, and so does a sleeve without such seams.
///
/// `skin` is the body's surface, of which `skeleton` has the joints. Returns the metres by which
/// the middle of each sleeve moved, per arm whose sleeve did. Linear in the vertices of the skin;
/// times some 2,000 moves in the seam points of sleeves.
std::map<BodyPart, double> centre_sleeves(const PanelMesh& garment,
                                          const std::vector<BodyPart>& part_of_point,
                                          const TriangleMesh& skin, const Skeleton& skeleton,
                                          std::vector<Vec3>& placed);

}  // namespace toile
