// Adjacency lists (CSR): the triangles at each vertex, the contacts at each node.
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// One list of items per group. The lists follow one another in memory.
template <typename Item>
class Adjacency {
 public:
  /// No groups.
  Adjacency() = default;
  template <typename List>
  Adjacency(std::size_t groups, const List& list) {
    assign(groups, list);
  }

  /// Makes `groups` groups, numbered from 0. `list(add)` calls add(group, item) for each item. It
  /// is called twice and has to list the same items both times. Items keep their order in a group.
  /// O(groups + items).
  template <typename List>
  void assign(std::size_t groups, const List& list) {
    first_.assign(groups + 1, 0);
    list([&](std::size_t group, const Item&) { ++first_[group + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    list([&](std::size_t group, const Item& item) { items_[next[group]++] = item; });
  }
  void clear() { first_.clear(), items_.clear(); }

  bool empty() const { return first_.empty(); }
  std::size_t size() const { return empty() ? 0 : first_.size() - 1; }

  /// The items of a group in [0, size()).
  std::span<const Item> operator[](std::size_t group) const {
    return {items_.data() + first_[group], items_.data() + first_[group + 1]};
  }

 private:
  std::vector<int> first_;  // per group, the index of its first item; then the number of items
  std::vector<Item> items_;
};

/// One corner of one triangle.
struct TriangleCorner {
  int triangle;  ///< index of the triangle
  int corner;    ///< 0 to 2
};

/// The corners at each vertex, in the order of the triangles. Vertices are in [0, `vertices`).
inline Adjacency<TriangleCorner> corners_by_vertex(const std::vector<Triangle>& triangles,
                                                   std::size_t vertices) {
  return {vertices, [&](const auto& add) {
            for (std::size_t t = 0; t < triangles.size(); ++t) {
              for (int c = 0; c < 3; ++c) add(triangles[t][c], {static_cast<int>(t), c});
            }
          }};
}

}  // namespace toile
