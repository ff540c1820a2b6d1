// The borders of a surface as closed loops.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// The loops of edges that belong to one triangle only. Each is a list of points in order; the last
/// one is joined to the first. At each point a loop goes on across the triangles that hang together
/// there. So holes that meet in a point have one loop. `points` is the number of points. Loops come
/// in the order of their lowest triangle. O(n log n).
std::vector<std::vector<int>> border_loops(const std::vector<Triangle>& triangles,
                                           std::size_t points);

}  // namespace toile
