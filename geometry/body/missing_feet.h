// Legs that end before a foot, as of a scan whose feet were cut off.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// The sides, "left" and "right", of the legs that end before a foot. A foot is half again as long
/// as the shin above it is deep. `body` stands upright on y = 0, with the joints of `skeleton`.
/// Costs some 100 slices.
std::vector<std::string> missing_feet(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
