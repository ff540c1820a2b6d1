// Finds stitches that cross the ones beside them.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Leaves out stitches that join two panels out of order.
///
/// Edges in a row are sewn to edges in a row of another panel, in the order in which both sides
/// pass along the seam. Of three and more that are not, the longest part in order stays. Each
/// stitch that is left out adds a warning to `remarks`. Patterns with an edge in two stitches are
/// left as they are. O(n^2) for n edges in a row.
void leave_out_crossed_stitches(Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
