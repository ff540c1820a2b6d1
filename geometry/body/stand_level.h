// Finds how a body that leans as a whole has to be turned to stand upright.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/body/skeleton.h"

namespace toile {

/// The rotation that brings a leaning body upright: the line from between the ankles to the neck's
/// base leans 0.6 degrees forward then. Of four bodies it leans 0.1 to 1.2 degrees forward and
/// less than 0.1 to a side. Nothing if it leans by less than `least_lean` radians from that, or if
/// one leg is ahead of the other. The body stands along y and faces +z.
std::optional<Eigen::Matrix3d> turn_upright(const Skeleton& skeleton, double least_lean);

/// Whether the soles of a body that stands along y are more level once it is turned. That tells a
/// scanner that was not level from a person who leans. O(n).
bool levels_soles(const Eigen::Matrix3d& turn, const TriangleMesh& body);

}  // namespace toile
