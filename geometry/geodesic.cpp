#include "geometry/geodesic.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

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

/// A part of a mesh, and whether it is all of it.
struct Patch {
  Mesh mesh;
  bool is_all = true;
};

/// The triangles of `mesh` that a line of at most `reach` metres from a to b may meet. Points in
/// one place are one, for CGAL does not stand facets without area.
Patch patch_around(const TriangleMesh& mesh, const Vec3& a, const Vec3& b, double reach) {
  Patch patch;
  std::map<std::array<double, 3>, Mesh::Vertex_index> vertices;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    double radius = 0;
    for (const int i : t) radius = std::max(radius, (mesh.points[i] - middle).norm());
    if ((middle - a).norm() + (middle - b).norm() - 2 * radius > reach) {
      patch.is_all = false;
      continue;
    }
    std::array<Mesh::Vertex_index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.points[t[k]];
      const auto [at, is_new] = vertices.try_emplace({p.x(), p.y(), p.z()});
      if (is_new) at->second = patch.mesh.add_vertex(point(p));
      corners[k] = at->second;
    }
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    patch.mesh.add_face(corners[0], corners[1], corners[2]);
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
  path.reserve(line.size());
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
    Patch patch = patch_around(mesh, a, b, reach);
    std::vector<Vec3> path = on_patch(patch.mesh, a, b);
    if (patch.is_all || share > max_detour || (!path.empty() && length_of(path) <= reach))
      return path;
  }
}

}  // namespace toile
