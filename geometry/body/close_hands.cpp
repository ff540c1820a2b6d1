#include "geometry/body/close_hands.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <string>
#include <vector>

namespace toile {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Metres beyond the wrist at which the hand begins. A thumb may end before the wrist's joint.
constexpr double hand_from = -0.03;
/// Metres from the line of the lower arm, within which a point may be the hand's.
constexpr double hand_radius = 0.2;
/// Share of the hull that gaps fill, below which a hand is left as it is.
constexpr double min_gaps = 0.15;

Mesh as_mesh(const TriangleMesh& body) {
  Mesh mesh;
  for (const Vec3& p : body.points) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (const Triangle& t : body.triangles) {
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  }
  return mesh;
}

TriangleMesh as_triangles(Mesh& mesh) {
  mesh.collect_garbage();
  TriangleMesh triangles;
  for (const auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    triangles.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    Triangle triangle;
    int i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      triangle[i++] = static_cast<int>(v.idx());
    }
    triangles.triangles.push_back(triangle);
  }
  return triangles;
}

/// The hull of a hand; empty where there is none.
Mesh hull_of_hand(const TriangleMesh& body, const Vec3& elbow, const Vec3& wrist) {
  const Vec3 axis = (wrist - elbow).normalized();
  std::vector<Kernel::Point_3> hand;
  for (const Vec3& p : body.points) {
    const double along = axis.dot(p - wrist);
    if (along < hand_from || (p - wrist - along * axis).norm() > hand_radius) continue;
    hand.emplace_back(p.x(), p.y(), p.z());
  }
  Mesh hull;
  if (hand.size() >= 4) CGAL::convex_hull_3(hand.begin(), hand.end(), hull);
  return hull;
}

}  // namespace

TriangleMesh with_hands_closed(const TriangleMesh& body, const Skeleton& skeleton) {
  Mesh mesh = as_mesh(body);
  bool closed = false;
  for (const std::string side : {"left", "right"}) {
    const auto elbow = skeleton.joints.find(side + "_elbow");
    const auto wrist = skeleton.joints.find(side + "_wrist");
    if (elbow == skeleton.joints.end() || wrist == skeleton.joints.end()) continue;
    Mesh hull = hull_of_hand(body, elbow->second, wrist->second);
    if (hull.number_of_faces() < 4) continue;
    const double filled = PMP::volume(hull);
    const double before = PMP::volume(mesh);
    Mesh copy = mesh;
    Mesh united;
    try {
      if (!PMP::corefine_and_compute_union(copy, hull, united,
                                           CGAL::parameters::throw_on_self_intersection(true))) {
        continue;
      }
    } catch (const PMP::Corefinement::Self_intersection_exception&) {
      continue;
    }
    if (PMP::volume(united) - before < min_gaps * filled) continue;
    mesh = std::move(united);
    closed = true;
  }
  return closed ? as_triangles(mesh) : body;
}

}  // namespace toile
