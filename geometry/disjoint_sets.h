// What belongs together, by pairs.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace toile {

/// Disjoint sets, each named by its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int of(int i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(int a, int b) {
    const auto [low, high] = std::minmax({of(a), of(b)});
    parent_[high] = low;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace toile
