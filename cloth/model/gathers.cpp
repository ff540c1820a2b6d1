#include "cloth/model/gathers.h"

#include <algorithm>

#include "pattern/constants.h"

namespace toile {

GatheredEdges gathered_edges(const PanelMesh& garment) {
  GatheredEdges shares;
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i + 1 < seam.a.size(); ++i) {
      if (!is_sewn(garment, seam.a[i]) || !is_sewn(garment, seam.a[i + 1])) continue;
      const std::pair<int, int> a = std::minmax(seam.a[i], seam.a[i + 1]);
      const std::pair<int, int> b = std::minmax(seam.b[i], seam.b[i + 1]);
      const double length_a = (garment.flat[a.first] - garment.flat[a.second]).norm();
      const double length_b = (garment.flat[b.first] - garment.flat[b.second]).norm();
      if (length_a > (1 + gather_threshold) * length_b) shares[a] = length_b / length_a;
      if (length_b > (1 + gather_threshold) * length_a) shares[b] = length_a / length_b;
    }
  }
  return shares;
}

GatheredEdges elastic_edges(const PanelMesh& garment) {
  GatheredEdges shares;
  if (garment.elastics.empty()) return shares;
  for (const MeshedElastic& elastic : garment.elastics) {
    for (std::size_t i = 0; i + 1 < elastic.points.size(); ++i) {
      shares[std::minmax(elastic.points[i], elastic.points[i + 1])] = elastic.ratio;
    }
  }
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i + 1 < seam.a.size(); ++i) {
      if (!is_sewn(garment, seam.a[i]) || !is_sewn(garment, seam.a[i + 1])) continue;
      const std::pair<int, int> a = std::minmax(seam.a[i], seam.a[i + 1]);
      const std::pair<int, int> b = std::minmax(seam.b[i], seam.b[i + 1]);
      const auto on_a = shares.find(a);
      const auto on_b = shares.find(b);
      if (on_a != shares.end()) shares.try_emplace(b, on_a->second);
      if (on_b != shares.end()) shares.try_emplace(a, on_b->second);
    }
  }
  return shares;
}

std::map<int, Vec2> gathered_rows(const PanelMesh& garment, const GatheredEdges& gathered) {
  if (gathered.empty()) return {};
  struct GatheredPoint {
    Vec2 along = Vec2::Zero();  // sum of its edges
    int edges = 0;
  };
  const auto add = [](Vec2& sum, const Vec2& along) {
    sum += sum.dot(along) < 0 ? Vec2(-along) : along;
  };
  std::map<int, GatheredPoint> gathered_points;  // by material point
  for (const auto& [edge, share] : gathered) {
    for (const int end : {edge.first, edge.second}) {
      add(gathered_points[end].along, garment.flat[edge.second] - garment.flat[edge.first]);
      ++gathered_points[end].edges;
    }
  }
  std::map<int, Vec2> rows;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    Vec2 along = Vec2::Zero();
    int touching = 0;
    bool inside = false;
    for (const int point : garment.triangles[t]) {
      const auto found = gathered_points.find(point);
      if (found == gathered_points.end()) continue;
      add(along, found->second.along);
      ++touching;
      inside = inside || found->second.edges > 1;
    }
    // A triangle that touches only the end of a gather may lie on the next seam, which has to hold.
    if (touching > 1 || inside) rows[static_cast<int>(t)] = along;
  }
  for (auto& [triangle, along] : rows) along.normalize();
  return rows;
}

}  // namespace toile
