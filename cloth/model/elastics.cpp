#include "cloth/model/elastics.h"

#include <cmath>
#include <map>

#include "cloth/model/gathers.h"

namespace toile {

std::vector<ElasticSegment> elastic_segments(const PanelMesh& garment, const Scene& scene,
                                             const std::vector<int>& node_of_point) {
  std::vector<ElasticSegment> segments;
  if (garment.elastics.empty()) return segments;
  std::map<std::pair<int, int>, std::size_t> at;  // by nodes
  const auto nodes_of = [&](int a, int b) -> std::pair<int, int> {
    return std::minmax(node_of_point[a], node_of_point[b]);
  };
  for (const MeshedElastic& elastic : garment.elastics) {
    for (std::size_t i = 0; i + 1 < elastic.points.size(); ++i) {
      const int a = elastic.points[i];
      const int b = elastic.points[i + 1];
      const double flat = (garment.flat[a] - garment.flat[b]).norm();
      at.try_emplace(nodes_of(a, b), segments.size());
      segments.push_back({{a, b}, elastic.ratio * flat, flat, elastic.stiffness, 0});
    }
  }
  const GatheredEdges edges = elastic_edges(garment);
  for (const MeshedPanel& panel : garment.panels) {
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      const Triangle& points = garment.triangles[t];
      for (int i = 0; i < 3; ++i) {
        const int a = points[i];
        const int b = points[(i + 1) % 3];
        if (!edges.contains(std::minmax(a, b))) continue;
        const Vec2 along = garment.flat[b] - garment.flat[a];
        const Vec2 to = garment.flat[points[(i + 2) % 3]] - garment.flat[a];
        const double depth = std::abs(along.x() * to.y() - along.y() * to.x()) / along.norm();
        const double angle = std::atan2(along.y(), along.x()) - panel.grain;
        segments[at.at(nodes_of(a, b))].cloth += modulus_at(fabric_of(scene, panel), angle) * depth;
      }
    }
  }
  return segments;
}

std::vector<ElasticMeasurement> measure_elastics(const PanelMesh& garment,
                                                 const std::vector<Vec3>& points) {
  std::vector<ElasticMeasurement> segments;
  for (const MeshedElastic& elastic : garment.elastics) {
    ElasticMeasurement& segment = segments.emplace_back();
    segment.name = elastic.name;
    for (std::size_t i = 0; i + 1 < elastic.points.size(); ++i) {
      const int a = elastic.points[i];
      const int b = elastic.points[i + 1];
      const double flat = (garment.flat[a] - garment.flat[b]).norm();
      const double now = (points[a] - points[b]).norm();
      segment.flat += flat;
      segment.now += now;
      segment.tension += flat * elastic.stiffness * std::max(now / (elastic.ratio * flat) - 1, 0.0);
    }
    segment.rest = elastic.ratio * segment.flat;
    segment.tension /= segment.flat;
  }
  return segments;
}

}  // namespace toile
