// Exact intersection tests between triangles: the judge of every drape.
#pragma once

#include <array>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Two triangles that meet, by index; for a mesh against itself, first < second.
using TrianglePair = std::array<int, 2>;

/// Pairs of triangles of `mesh` that intersect, other than in the vertices and edges that they
/// share. Decided with exact predicates on the coordinates as given; a triangle without area counts
/// as the segment or point that it is. About O(n log n) for a mesh that hardly touches itself.
/// Sorted.
std::vector<TrianglePair> self_intersections(const TriangleMesh& mesh);

/// Pairs (triangle of `first`, triangle of `second`) that intersect, touching included. Exact and
/// sorted as above.
std::vector<TrianglePair> intersections(const TriangleMesh& first, const TriangleMesh& second);

}  // namespace toile
