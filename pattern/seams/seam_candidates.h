// Pairs of sides that may be sewn together, each with what speaks for it.
#pragma once

#include <vector>

#include "pattern/seams/panel_symmetry.h"
#include "pattern/seams/panel_words.h"
#include "pattern/seams/seam_weights.h"
#include "pattern/seams/walked_edges.h"

namespace toile {

/// Edges in a row along an outline.
struct SeamSide {
  int first = 0;  ///< index of an edge
  int count = 1;
};

/// Two sides that may be sewn, right side to right side. The start of one meets the end of the
/// other, both walked as walked_edges() walks them.
struct SeamCandidate {
  SeamSide a;
  SeamSide b;
  double worth = 0;  ///< of its sides alone
};

/// What seams are found from.
struct SeamEvidence {
  std::vector<WalkedEdge> edges;
  std::vector<PanelWords> words;  ///< per panel
  std::vector<int> mirror;        ///< per edge, see mirror_partners()
  EdgeShapes shapes;
};

/// The best candidates of each edge, and those that continue a good one along the outlines.
/// O(edges^2 log(edges)), and O(edges^3) where most edges are equally long.
std::vector<SeamCandidate> seam_candidates(const SeamEvidence& evidence,
                                           const SeamMeasures& weights);

/// The edges of a side, in the order of the walk.
std::vector<int> edges_of(const std::vector<WalkedEdge>& edges, const SeamSide& side);

}  // namespace toile
