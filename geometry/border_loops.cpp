#include "geometry/border_loops.h"

#include <algorithm>
#include <utility>

#include "geometry/half_edges.h"

namespace toile {

namespace {

/// The border edges of a surface, walked one after another.
class BorderWalk {
 public:
  BorderWalk(const std::vector<Triangle>& triangles, std::size_t points)
      : triangles_(triangles),
        sides_(half_edges(triangles, points)),
        is_walked_(sides_.size(), 0) {}

  std::vector<std::vector<int>> loops() {
    std::vector<std::vector<int>> loops;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const int from = triangles_[t][i];
        const int to = triangles_[t][(i + 1) % 3];
        const auto [first, last] = at_edge(from, to);
        if (last - first > 1 || is_walked_[first]) continue;
        loops.push_back(loop_from(from, to, static_cast<int>(t)));
      }
    }
    return loops;
  }

 private:
  static std::pair<int, int> edge_of(const HalfEdge& side) { return {side.low, side.high}; }
  /// The range of sides_ that are the edge's.
  std::pair<std::size_t, std::size_t> at_edge(int a, int b) const {
    const std::pair<int, int> edge = std::minmax(a, b);
    const auto first = std::ranges::lower_bound(sides_, edge, {}, edge_of);
    const auto last = std::ranges::upper_bound(sides_, edge, {}, edge_of);
    return {first - sides_.begin(), last - sides_.begin()};
  }

  int third_point(int triangle, int a, int b) const {
    for (const int p : triangles_[triangle]) {
      if (p != a && p != b) return p;
    }
    return a;
  }

  /// The loop through the border edge from `from` to `to` of the triangle `beside`.
  std::vector<int> loop_from(int from, int to, int beside) {
    std::vector<int> loop;
    for (std::size_t edge = at_edge(from, to).first; !is_walked_[edge];
         edge = at_edge(from, to).first) {
      is_walked_[edge] = 1;
      loop.push_back(from);
      // Around the point `to`, across the triangles that hang together, to the next border edge.
      int other = from;
      for (std::size_t turns = 0; turns < triangles_.size(); ++turns) {
        other = third_point(beside, other, to);
        const auto [first, last] = at_edge(other, to);
        if (last - first == 1) break;
        beside =
            sides_[first].triangle != beside ? sides_[first].triangle : sides_[first + 1].triangle;
      }
      from = std::exchange(to, other);
    }
    return loop;
  }

  const std::vector<Triangle>& triangles_;
  std::vector<HalfEdge> sides_;
  std::vector<char> is_walked_;  // per side
};

}  // namespace

std::vector<std::vector<int>> border_loops(const std::vector<Triangle>& triangles,
                                           std::size_t points) {
  return BorderWalk(triangles, points).loops();
}

}  // namespace toile
