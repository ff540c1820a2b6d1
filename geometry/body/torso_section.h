// The sections of a body that tailors measure trunk and head by.
#pragma once

#include <optional>

#include "geometry/slice.h"
#include "geometry/types.h"

namespace toile {

/// The section of the torso at a height in metres, between crotch and armpits. It is the largest of
/// the body's sections there. Nothing if that is not closed. O(n).
std::optional<Section> torso_section(const TriangleMesh& body, double height);

/// The level section of the greatest girth around the upper half of the head. `neck` and `crown`
/// are heights in metres. Nothing if there is none. Costs about 30 passes over the body.
std::optional<Section> head_section(const TriangleMesh& body, double neck, double crown);

}  // namespace toile
