// Into how many steps each edge of a pattern is cut: how seam sides of other lengths pair up.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Steps on the coarsest level, per panel and edge, at least 1.
using EdgeSteps = std::vector<std::vector<int>>;

/// Steps of about `edge_length` metres; shorter where a curve turns. The two sides of a stitch get
/// the same number, the larger of both. So the i-th point of one side meets the i-th of the other.
/// A gathered side is spread evenly along the seam. An edge whose ends are sewn together gets two
/// steps and more. `factors`, at least 1 each, are of the steps that an edge gets; empty: all 1.
EdgeSteps steps_along(const Pattern& pattern, double edge_length, const EdgeSteps& factors = {});

}  // namespace toile
