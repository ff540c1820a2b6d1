// Mends rows of edges that are sewn to each other out of order.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Sews rows of edges as one edge where their stitches cross.
///
/// Edges in a row are sewn to edges in a row of another panel, in the order in which both sides
/// pass along the seam. Of three and more that are not, the longest takes in the whole row, on both
/// sides. Its stitch sews both rows from end to end; the other stitches are left out.
///
/// - Edges keep their numbers. The outline no longer runs along those that are taken in.
/// - Rows with an elastic or an attachment stay as they are.
/// - Each row is a warning in `remarks`. Patterns with an edge in two stitches are left as they
/// are.
///
/// O(n^2) for n edges in a row.
void sew_crossed_rows_as_one(Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
