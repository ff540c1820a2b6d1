// Disjoint sets of integers: which items are joined, directly or through others.
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Disjoint sets of the items 0 to count - 1, each named by its lowest item. Path halving makes a
/// call O(log count) on average [Tarjan & van Leeuwen 1984].
class DisjointSets {
 public:
  /// Every item is a set of its own.
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The lowest item of the set that holds `i`. It shortens paths, so threads must not call it at
  /// the same time.
  int of(int i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /// Joins the sets that hold `a` and `b`.
  void join(int a, int b) {
    a = of(a);
    b = of(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
  }

  /// The triangles, each corner replaced by the lowest item of its set.
  std::vector<Triangle> joined(std::vector<Triangle> triangles) {
    for (Triangle& t : triangles) {
      for (int& corner : t) corner = of(corner);
    }
    return triangles;
  }

 private:
  std::vector<int> parent_;  // per item, an item of its set that is no higher
};

}  // namespace toile
