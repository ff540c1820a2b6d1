// Chooses the seams of a whole garment at once.
#pragma once

#include <vector>

#include "pattern/seams/corner_groups.h"

namespace toile {

struct ChosenSeam {
  int candidate = 0;
  /// By how much the garment is worth less without this seam, at least. Seams that differ in which
  /// of equal pieces they join count as this seam.
  double margin = 0;
  int alternative = -1;  ///< the best other candidate for one of its edges; -1: none, it stays open
};

struct SeamAssignment {
  std::vector<ChosenSeam> chosen;  ///< ascending by candidate
  double worth = 0;
  bool proved = false;  ///< no other choice is worth more
};

/// What is known of the seams beforehand.
struct KnownSeams {
  std::vector<int> chosen;  ///< candidates
  std::vector<int> taken;   ///< edges that no candidate may use
};

/// The integer programme. Each edge is in one seam at most. Both halves of the garment have the
/// same seams where mirror partners are known. A group of corners counts where all its seams are
/// chosen. Parts that are sewn to nothing cost something, and the garment has no handle.
SeamAssignment assign_seams(const SeamEvidence& evidence,
                            const std::vector<SeamCandidate>& candidates,
                            const std::vector<CornerGroup>& groups, const KnownSeams& known);

}  // namespace toile
