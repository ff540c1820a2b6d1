// The vertices of a garment in motion, which contact acts on: material points or nodes.
#pragma once

#include <cstddef>
#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/adjacency.h"

namespace toile {

/// The vertices of the cloth's surface. While seams stand open, they are the model's material
/// points, so that the two sides of a seam touch things separately. Once the seams are sewn, they
/// are the nodes.
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

  /// Values per vertex, from values per node.
  std::vector<double> spread(const std::vector<double>& per_node) const {
    if (!are_points) return per_node;
    std::vector<double> values;
    for (const int node : node_of_point) values.push_back(per_node[node]);
    return values;
  }

  const bool are_points;  ///< material points, not nodes
  const std::size_t count;
  const std::vector<Triangle>& triangles;  ///< indices of vertices
  const std::vector<int>& node_of_point;
  const Adjacency<int> of_node;  ///< per node, its vertices
};

}  // namespace toile
