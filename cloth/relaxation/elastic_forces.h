// Forces of elastics on the vertices along them.
#pragma once

#include "cloth/model/garment_model.h"
#include "geometry/adjacency.h"
#include "geometry/vec4.h"

namespace toile {

/// Forces of elastics.
class ElasticForces {
 public:
  /// With `of_points` the vertices are the model's material points: its seams stand open. Without,
  /// they are its nodes.
  ElasticForces(const GarmentModel& model, bool of_points);

  bool empty() const { return segments_.empty(); }
  /// Adds the elastics' forces (N) on vertices `begin` to `end` to `force`. `x`: metres, one a
  /// vertex.
  void add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const;

 private:
  struct Entry {
    int other;
    ElasticSegment segment;
  };
  Adjacency<Entry> segments_;  // per vertex; empty: the model has no elastics
};

}  // namespace toile
