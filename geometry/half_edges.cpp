#include "geometry/half_edges.h"

#include <algorithm>
#include <tuple>

namespace toile {

std::vector<HalfEdge> half_edges(std::span<const Triangle> triangles, std::size_t points) {
  // Files the sides under their smaller end, then sorts the few that share it.
  std::vector<std::size_t> first(points + 1, 0);
  const auto each = [&](const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const int from = triangles[t][(i + 1) % 3];
        const int to = triangles[t][(i + 2) % 3];
        visit(HalfEdge{std::min(from, to), std::max(from, to), static_cast<int>(t), i, from < to});
      }
    }
  };
  each([&](const HalfEdge& side) { ++first[static_cast<std::size_t>(side.low) + 1]; });
  for (std::size_t p = 1; p <= points; ++p) first[p] += first[p - 1];
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  std::vector<HalfEdge> sides(3 * triangles.size());
  each([&](const HalfEdge& side) { sides[next[static_cast<std::size_t>(side.low)]++] = side; });
  for (std::size_t p = 0; p < points; ++p) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(first[p]),
              sides.begin() + static_cast<std::ptrdiff_t>(first[p + 1]),
              [](const HalfEdge& a, const HalfEdge& b) {
                return std::tie(a.high, a.triangle, a.opposite) <
                       std::tie(b.high, b.triangle, b.opposite);
              });
  }
  return sides;
}

std::vector<std::array<int, 2>> unique_edges(std::span<const Triangle> triangles) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace toile
