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

Kernel::Point_3 point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// The triangles of `mesh` that may reach into the ellipsoid.
Mesh patch_around(const TriangleMesh& mesh, const Vec3& a, const Vec3& b) {
  // No line that is a quarter longer than the straight one leaves it. Shoulders and arms bend less.
  const double reach = 1.25 * (b - a).norm() + 0.02;
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

}  // namespace

std::vector<Vec3> geodesic(const TriangleMesh& mesh, const Vec3& a, const Vec3& b) {
  if ((b - a).norm() < 1e-9) return {};
  Mesh patch = patch_around(mesh, a, b);
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

}  // namespace toile
