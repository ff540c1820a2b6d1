// Exact intersection tests between triangles, by which every drape is judged.
#pragma once

#include <array>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Indices of two triangles that meet. For a mesh against itself the first is the smaller.
using TrianglePair = std::array<int, 2>;

/// Pairs of triangles of `mesh` that intersect, other than in the vertices and edges that they
/// share, sorted. Exact predicates on the given coordinates decide. A triangle without area counts
/// as the segment or point that it is. About O(n log n) for a mesh that hardly touches itself.
std::vector<TrianglePair> self_intersections(const TriangleMesh& mesh);

/// Pairs (triangle of `first`, triangle of `second`) that intersect or touch, sorted. Exact
/// predicates decide, as for self_intersections().
std::vector<TrianglePair> intersections(const TriangleMesh& first, const TriangleMesh& second);

}  // namespace toile
