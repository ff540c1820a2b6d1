// Whether a mesh bounds a solid, so that inside and outside have a meaning.
#pragma once

#include <string>

#include "geometry/types.h"

namespace toile {

/// What keeps `mesh` from being a closed, outward-oriented surface, as the end of a sentence ("has
/// 12 border edges"); empty when nothing does. Looks at edges and at the enclosed volume only: a
/// closed surface may still intersect itself. O(n log n).
std::string closed_surface_defect(const TriangleMesh& mesh);

}  // namespace toile
