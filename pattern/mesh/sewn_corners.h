// Corners of panels that seams join: where seams meet end to end.
#pragma once

#include <array>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "pattern/pattern.h"

namespace toile {

/// The corners of all outlines, by number. Corners that seams join have the same number.
class SewnCorners {
 public:
  /// O(stitches * edges of a panel).
  explicit SewnCorners(const Pattern& pattern);

  /// The corner where step `step` of the panel's outline begins.
  int at(int panel, int step) { return sewn_.of(first_[static_cast<std::size_t>(panel)] + step); }

  /// The corners at the start and at the end of an edge that its outline runs along.
  std::array<int, 2> ends(const EdgeRef& ref);

 private:
  const Pattern& pattern_;
  std::vector<int> first_;  ///< per panel, the item of its corner 0
  DisjointSets sewn_;
};

}  // namespace toile
