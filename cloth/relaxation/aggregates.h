// Aggregates of vertices: patches of the cloth wider than the triangles of the coarsest mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/adjacency.h"
#include "geometry/types.h"

namespace toile {

/// The weight with which a vertex belongs to an aggregate. The weights of a vertex add up to 1.
struct AggregateShare {
  int aggregate;
  double weight;
};

/// Per vertex, the vertices that share an edge with it, ascending.
using Neighbours = std::vector<std::vector<int>>;
Neighbours neighbours_of(const std::vector<Triangle>& triangles, std::size_t vertices);

/// Overlapping aggregates about three edges across, about a quarter as many as vertices. They lie
/// around vertices of which no two are neighbours. The other vertices are shared out among the
/// aggregates next to them. Then the weights are smoothed once [after Vaněk, Mandel & Brezina 1996,
/// smoothed aggregation].
struct Aggregates {
  std::vector<int> middles;               ///< per aggregate, its middle vertex
  Adjacency<AggregateShare> of_vertices;  ///< per vertex, one or more
  Neighbours neighbours;                  ///< per aggregate, those it shares an edge with
};

/// Aggregates the vertices, given their neighbours. Linear in the edges.
Aggregates aggregate(const Neighbours& vertices);

}  // namespace toile
