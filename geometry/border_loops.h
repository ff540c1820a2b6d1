// The borders of a surface as closed loops.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// The loops of edges that belong to one triangle only. Each is a list of points in order; the last
/// one is joined to the first. Loops that meet in a point stay apart: a loop goes on at the next
/// border edge around its point. `points` is the number of points. Loops come in the order of their
/// lowest triangle. O(n log n).
std::vector<std::vector<int>> border_loops(const std::vector<Triangle>& triangles,
                                           std::size_t points);

}  // namespace toile
