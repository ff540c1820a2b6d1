// The sides of a mesh's triangles, those along one edge next to each other.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// One side of one triangle.
struct HalfEdge {
  int low;       ///< its ends, the smaller point index
  int high;      ///< and the larger
  int triangle;  ///< index of the triangle
  int opposite;  ///< 0 to 2: the triangle's corner that is not on it
  bool forward;  ///< the triangle runs from `low` to `high`

  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// All sides of all triangles, by edge (low, high), then by triangle and corner. Every point index
/// is in [0, points). Linear for meshes whose points have few triangles each.
std::vector<HalfEdge> half_edges(std::span<const Triangle> triangles, std::size_t points);

/// The edges of the triangles as {lower point, higher point}, each once, sorted. O(n log n).
std::vector<std::array<int, 2>> unique_edges(std::span<const Triangle> triangles);

}  // namespace toile
