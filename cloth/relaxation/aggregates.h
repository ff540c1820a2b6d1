// Patches wider than the triangles of the coarsest mesh: what it is too fine for moves as a whole.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/adjacency.h"
#include "geometry/types.h"

namespace toile {

/// Of a vertex to a aggregate, of those it belongs to: in all 1.
struct AggregateShare {
  int aggregate;
  double weight;
};

/// Per vertex, the others that are joined to it, ascending.
using Neighbours = std::vector<std::vector<int>>;
Neighbours neighbours_of(const std::vector<Triangle>& triangles, std::size_t vertices);

/// Overlapping patches about three edges across, some four times as few as vertices: around
/// vertices of which no two are neighbours, the others shared out among those next to them, and
/// that smoothed once [after Vaněk, Mandel & Brezina 1996, smoothed aggregation].
struct Aggregates {
  std::vector<int> middles;               ///< per aggregate, the vertex that it is around
  Adjacency<AggregateShare> of_vertices;  ///< per vertex
  Neighbours neighbours;                  ///< per patch
};

/// Linear in the joints. Each vertex belongs to one patch or more.
Aggregates aggregate(const Neighbours& vertices);

}  // namespace toile
