// Runs of edges that may be sewn to each other once some of them are cut.
#pragma once

#include <array>
#include <vector>

#include "pattern/seams/cut_edges.h"
#include "pattern/seams/seam_pairs.h"

namespace toile {

/// Edges that follow each other on the border of a garment, and others that they may be sewn to.
/// The first of the one side meets the last of the other. Where only one side has a joint, the
/// other is cut. So a cap is sewn to front and back, a band to all that hangs on it.
struct SeamRun {
  EdgeCuts cuts;  ///< of edges as drawn, beside those that the pattern has; on both halves
  std::vector<std::array<PanelPart, 2>> seams;
  double gain = 0;  ///< of the score, by the odds of the pairs alone
};

/// The runs that gain something, the best first. `found` are the seams of the cut pattern. Edges of
/// likely seams stay in them, those of given ones are left alone. O(edges^2) runs are looked at.
std::vector<SeamRun> seam_runs(const CutPattern& cut, bool drawn_walk, const FoundSeams& found);

}  // namespace toile
