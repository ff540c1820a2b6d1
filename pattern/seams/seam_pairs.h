// Which pairs of edges may be sewn, and how likely each is.
#pragma once

#include "pattern/seams/pair_features.h"
#include "pattern/seams/seam_evidence.h"
#include "pattern/seams/seam_weights.h"

namespace toile {

/// Each pair of edges as a seam, right side to right side. The start of one meets the end of the
/// other, both walked as walked_edges() walks them.
class SeamPairs {
 public:
  explicit SeamPairs(const SeamEvidence& evidence);

  bool possible(int a, int b) const;
  /// Of a possible pair.
  SeamMeasures measures(int a, int b) const;
  /// Logarithm of the odds that a pair is sewn, whichever is named first.
  double odds(int a, int b) const;
  /// See PairFeatures.
  void follow() { features_.follow(); }

 private:
  const std::vector<WalkedEdge>& edges_;
  const std::vector<PanelWords>& words_;
  PairFeatures features_;
};

}  // namespace toile
