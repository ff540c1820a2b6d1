// What touches things while a garment moves: its material points, or its nodes.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/adjacency.h"

namespace toile {

/// The vertices of the cloth's surface. While seams stand open they are the model's material
/// points, so that both sides of a seam touch things on their own; once sewn, they are its nodes.
struct Vertices {
  Vertices(const GarmentModel& model, bool points)
      : are_points(points),
        count(points ? model.node_of_point.size() : static_cast<std::size_t>(model.nodes)),
        triangles(points ? model.triangles : model.node_triangles),
        node_of_point(model.node_of_point),
        of_node(model.nodes, [&](const auto& add) {
          for (std::size_t v = 0; v < count; ++v) {
            add(points ? model.node_of_point[v] : v, static_cast<int>(v));
          }
        }) {}

  /// The same values per vertex.
  std::vector<double> spread(const std::vector<double>& per_node) const {
    if (!are_points) return per_node;
    std::vector<double> values;
    for (const int node : node_of_point) values.push_back(per_node[node]);
    return values;
  }

  const bool are_points;
  const std::size_t count;
  const std::vector<Triangle>& triangles;  ///< of vertices
  const std::vector<int>& node_of_point;
  const Adjacency<int> of_node;  ///< per node, its vertices
};

}  // namespace toile
