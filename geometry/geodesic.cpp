#include "geometry/geodesic.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <iterator>

namespace toile {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;
using TreeTraits = CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>;

/// Length of a line on the skin over the straight one, beyond which nobody looks for a shorter one.
constexpr double max_detour = 50;

Kernel::Point_3 point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// The triangles of `mesh` that a line of at most `reach` metres from a to b may meet.
Mesh patch_around(const TriangleMesh& mesh, const Vec3& a, const Vec3& b, double reach) {
  Mesh patch;
  std::vector<Mesh::Vertex_index> vertices(mesh.points.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    double radius = 0;
    for (const int i : t) radius = std::max(radius, (mesh.points[i] - middle).norm());
    if ((middle - a).norm() + (middle - b).norm() - 2 * radius > reach) continue;
    for (const int i : t) {
      if (!vertices[i].is_valid()) vertices[i] = patch.add_vertex(point(mesh.points[i]));
    }
    patch.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  }
  return patch;
}

/// The shortest line on the patch; empty where it does not join the points.
std::vector<Vec3> on_patch(Mesh& patch, const Vec3& a, const Vec3& b) {
  if (patch.number_of_faces() == 0) return {};
  ShortestPath paths(patch);
  CGAL::AABB_tree<TreeTraits> tree;
  paths.build_aabb_tree(tree);
  const auto from = paths.locate(point(a), tree);
  const auto to = paths.locate(point(b), tree);
  paths.add_source_point(from);
  std::vector<Kernel::Point_3> line;
  paths.shortest_path_points_to_source_points(to.first, to.second, std::back_inserter(line));
  std::vector<Vec3> path;
  for (const Kernel::Point_3& p : line) path.emplace_back(p.x(), p.y(), p.z());
  std::reverse(path.begin(), path.end());
  if (path.size() < 2) path.clear();
  return path;
}

double length_of(const std::vector<Vec3>& path) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
  return length;
}

}  // namespace

std::vector<Vec3> geodesic(const TriangleMesh& mesh, const Vec3& a, const Vec3& b) {
  const double straight = (b - a).norm();
  if (straight < 1e-9) return {};
  // Lines on shoulders and arms are less than a quarter longer than straight ones. A line that is
  // longer than the patch was made for may be cut short by the patch's border.
  constexpr double margin = 0.02;  // metres
  for (double share = 1.25;; share *= 2) {
    const double reach = share * straight + margin;
    Mesh patch = patch_around(mesh, a, b, reach);
    const bool is_all = patch.number_of_faces() == mesh.triangles.size();
    std::vector<Vec3> path = on_patch(patch, a, b);
    if (is_all || share > max_detour || (!path.empty() && length_of(path) <= reach)) return path;
  }
}

}  // namespace toile
