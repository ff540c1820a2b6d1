// Pairs of sides that may be sewn together, each with what speaks for it.
#pragma once

#include <vector>

#include "pattern/seams/outline_edges.h"
#include "pattern/seams/panel_symmetry.h"
#include "pattern/seams/panel_words.h"
#include "pattern/seams/seam_weights.h"

namespace toile {

/// Edges in a row along an outline.
struct SeamSide {
  int first = 0;  ///< index of an edge
  int count = 1;
};

/// Two sides that may be sewn, right side to right side. The start of one meets the end of the
/// other, both walked as outline_edges() walks them.
struct SeamCandidate {
  SeamSide a;
  SeamSide b;
  SeamMeasures measures{};  ///< of its sides alone
  double worth = 0;         ///< by those
};

/// What seams are found from.
struct SeamEvidence {
  std::vector<OutlineEdge> edges;
  std::vector<PanelWords> words;  ///< per panel
  std::vector<int> mirror;        ///< per edge, see mirror_partners()
  EdgeShapes shapes;
};

/// The best candidates of each edge, and those that continue a good one along the outlines.
/// O(edges^2 log(edges)).
std::vector<SeamCandidate> seam_candidates(const SeamEvidence& evidence,
                                           const SeamMeasures& weights);

/// The edges of a side, in the order of the walk.
std::vector<int> edges_of(const std::vector<OutlineEdge>& edges, const SeamSide& side);

}  // namespace toile
