// A mesh of fewer triangles and the same shape, for display.
#pragma once

#include "geometry/types.h"

namespace toile {

/// Collapses edges until `triangles` triangles are left, or until a further collapse would change
/// the topology. Edges that change the shape least go first [Garland & Heckbert 1997]. It returns a
/// mesh unchanged that is small enough or has an edge of three triangles. About O(n log n).
TriangleMesh decimate(const TriangleMesh& mesh, int triangles);

}  // namespace toile
