// The section of a body that tailors measure the trunk by.
#pragma once

#include <optional>

#include "geometry/slice.h"
#include "geometry/types.h"

namespace toile {

/// The section of the torso at a height in metres, between crotch and armpits. It is the largest of
/// the body's sections there. Nothing if that is not closed. O(n).
std::optional<Section> torso_section(const TriangleMesh& body, double height);

}  // namespace toile
