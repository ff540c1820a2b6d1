// A lighter mesh of the same shape, to be looked at.
#pragma once

#include "geometry/types.h"

namespace toile {

/// Collapses edges, those first that change the shape least [Garland & Heckbert 1997], until
/// `triangles` are left or none can go without changing the topology. A mesh that is small enough,
/// or that has an edge of three triangles, is returned as it is. About O(n log n).
TriangleMesh decimate(const TriangleMesh& mesh, int triangles);

}  // namespace toile
