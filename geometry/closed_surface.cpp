#include "geometry/closed_surface.h"

#include <Eigen/Geometry>
#include <vector>

#include "geometry/half_edges.h"

namespace toile {

namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

}  // namespace

std::string closed_surface_defect(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "has no triangles";
  double volume = 0;
  const Vec3& origin = mesh.points[static_cast<std::size_t>(mesh.triangles[0][0])];
  for (const Triangle& triangle : mesh.triangles) {
    const auto from_origin = [&](std::size_t k) -> Vec3 {
      return mesh.points[static_cast<std::size_t>(triangle[k])] - origin;
    };
    volume += from_origin(0).dot(from_origin(1).cross(from_origin(2)));
  }
  const std::vector<HalfEdge> edges = half_edges(mesh.triangles, mesh.points.size());
  std::size_t border = 0;
  std::size_t crowded = 0;
  std::size_t turned = 0;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].same_edge(edges[i])) ++end;
    if (end - i == 1) ++border;
    if (end - i > 2) ++crowded;
    if (end - i == 2 && edges[i].forward == edges[i + 1].forward) ++turned;
    i = end;
  }
  if (border > 0) return "has " + counted(border, "border edge", "border edges");
  if (crowded > 0) {
    return "has " + counted(crowded, "edge", "edges") + " with more than two triangles";
  }
  if (turned > 0) {
    return "has " + counted(turned, "edge", "edges") + " whose triangles face opposite sides";
  }
  if (!(volume > 0)) return "is inside out or encloses nothing";
  return "";
}

}  // namespace toile
