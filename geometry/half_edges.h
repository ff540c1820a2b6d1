// The edges of a mesh, and the sides of its triangles sorted by edge.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// One side of one triangle.
struct HalfEdge {
  int low;       ///< the smaller point index of its two ends
  int high;      ///< the larger point index
  int triangle;  ///< index of the triangle
  int opposite;  ///< 0 to 2: the triangle's corner off this side
  bool forward;  ///< the triangle runs from `low` to `high`

  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// All sides of all triangles, sorted by edge (low, high), then by triangle and corner. Every point
/// index is in [0, points). O(n) for meshes whose points have few triangles each.
std::vector<HalfEdge> half_edges(std::span<const Triangle> triangles, std::size_t points);

/// The edges of the triangles as {lower point, higher point}, each once, sorted. O(n log n).
std::vector<std::array<int, 2>> unique_edges(std::span<const Triangle> triangles);

}  // namespace toile
