// Merges edges that are too short to mesh with their neighbours.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Merges every edge shorter than short_edge_length with a neighbour on its outline.
///
/// - The neighbour that changes the outline least moves its end to the far end of the short edge.
///   No point of the outline moves farther than max_outline_shift.
/// - A short edge that is sewn is merged on both sides, and its stitch is left out. The other side
///   may be twice as long. What the stitch joins must stay joined by other stitches.
/// - Edges keep their numbers. The outline no longer runs along merged ones. What an attachment
///   held of them, it holds where they were.
/// - Edges with an elastic stay, and so do short edges in a row that draw a curve together. An edge
///   stays where the outline would cross itself without it.
///
/// Each merged edge adds a warning to `remarks`. Patterns with an edge in two stitches are left as
/// they are. O(edges) for each merged edge.
void merge_short_edges(Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
