#include "cloth/relaxation/elastic_forces.h"

#include <cmath>

namespace toile {

ElasticForces::ElasticForces(const GarmentModel& model, bool of_points) {
  if (model.elastics.empty()) return;
  const auto vertex = [&](int point) { return of_points ? point : model.node_of_point[point]; };
  const std::size_t vertices = of_points ? model.node_of_point.size() : model.nodes;
  segments_ = Adjacency<Entry>(vertices, [&](const auto& add) {
    for (const ElasticSegment& segment : model.elastics) {
      const int a = vertex(segment.points[0]);
      const int b = vertex(segment.points[1]);
      add(a, {b, segment});
      add(b, {a, segment});
    }
  });
}

void ElasticForces::add(std::size_t begin, std::size_t end, const Vec4s& x, Vec4s& force) const {
  for (std::size_t v = begin; v < end; ++v) {
    for (const auto& [other, segment] : segments_[v]) {
      const Vec4 displacement = x[other] - x[v];
      const double length = std::sqrt(squared_length(displacement));
      if (length > 0) force[v] += elastic_tension(segment, length) / length * displacement;
    }
  }
}

}  // namespace toile
