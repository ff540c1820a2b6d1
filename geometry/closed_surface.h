// Whether a mesh bounds a solid, so that it has an inside and an outside.
#pragma once

#include <string>

#include "geometry/types.h"

namespace toile {

/// The defect that keeps `mesh` from being a closed, outward-oriented surface, as the end of a
/// sentence ("has 12 border edges"). Empty for a sound mesh. The function checks edges and the
/// enclosed volume only: a closed surface may still intersect itself. O(n log n).
std::string closed_surface_defect(const TriangleMesh& mesh);

}  // namespace toile
