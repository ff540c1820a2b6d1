// Pulls of elastics on the vertices along them.
#pragma once

#include "cloth/model/garment_model.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// Vertices are the model's nodes, or its material points while seams stand open.
class ElasticForces {
 public:
  ElasticForces(const GarmentModel& model, bool of_points);

  bool empty() const { return segments_.empty(); }
  /// Adds to the forces (N) on vertices `begin` to `end`, with all vertices at `x`.
  void add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const;

 private:
  struct Entry {
    int other;
    ElasticSegment segment;
  };
  Adjacency<Entry> segments_;  // per vertex; empty: no elastics
};

}  // namespace toile
