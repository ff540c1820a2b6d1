#include "geometry/surface_distance.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/closest_points.h"
#include "geometry/error.h"
#include "geometry/half_edges.h"
#include "geometry/parallel.h"
#include "geometry/triangle_tree.h"

namespace toile {

namespace {

// triangles_in_box() needs no exact predicates.
using Kernel = CGAL::Simple_cartesian<double>;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

double corner_angle(const Vec3& at, const Vec3& to, const Vec3& also_to) {
  const Vec3 u = to - at;
  const Vec3 v = also_to - at;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Metres, signed, at `away` from the closest point, which lies on the border of a sheet with that
/// normal.
double beside_border(const Vec3& away, const Vec3& normal) {
  const double distance = away.norm();
  const double behind = -away.dot(normal);
  if (behind <= 0) return distance;
  const double beyond = std::sqrt(std::max(0.0, distance * distance - behind * behind));
  const double zero = std::min(behind, SurfaceDistance::border_bevel);
  return distance * (beyond - zero) / (beyond + zero);
}

}  // namespace

struct SurfaceDistance::Tree {
  explicit Tree(const TriangleMesh& surface) : mesh(surface) {
    parallel_invoke([this] { tree.emplace(mesh); }, [this] { compute_normals(); });
  }

  const TriangleMesh mesh;
  std::optional<TriangleTree> tree;
  std::vector<Vec3> face_normals;
  std::vector<std::array<Vec3, 3>> edge_normals;  // per triangle, of the edge opposite to corner i
  std::vector<Vec3> vertex_normals;
  std::vector<std::array<char, 3>> edge_is_border;
  std::vector<char> vertex_is_border;

  /// The face, edge or vertex that holds a closest point.
  struct Feature {
    Vec3 normal;
    bool border;
  };
  void compute_normals();
  Feature feature_at(int triangle, const Vec3& weights) const;
  SurfacePoint describe(const Vec3& query, int triangle) const;
};

void SurfaceDistance::Tree::compute_normals() {
  const std::size_t count = mesh.triangles.size();
  face_normals.resize(count);
  edge_normals.resize(count);
  edge_is_border.resize(count);
  vertex_normals.assign(mesh.points.size(), Vec3::Zero());
  vertex_is_border.assign(mesh.points.size(), 0);
  std::vector<Vec3> angles(count);  // radians, at the triangles' corners
  parallel_for_items(count, [&](std::size_t t) {
    const Triangle& corners = mesh.triangles[t];
    const Vec3& a = mesh.points[corners[0]];
    const Vec3& b = mesh.points[corners[1]];
    const Vec3& c = mesh.points[corners[2]];
    face_normals[t] = (b - a).cross(c - a).normalized();
    angles[t] = {corner_angle(a, b, c), corner_angle(b, c, a), corner_angle(c, a, b)};
  });
  for (std::size_t t = 0; t < count; ++t) {
    for (int i = 0; i < 3; ++i) {
      vertex_normals[mesh.triangles[t][i]] += angles[t][i] * face_normals[t];
    }
  }
  for (Vec3& normal : vertex_normals) normal.normalize();
  const std::vector<HalfEdge> sides = half_edges(mesh.triangles, mesh.points.size());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    Vec3 normal = Vec3::Zero();
    for (; end < sides.size() && sides[end].same_edge(sides[i]); ++end) {
      normal += face_normals[sides[end].triangle];
    }
    normal.normalize();
    const bool is_border = end - i == 1;
    if (is_border) vertex_is_border[sides[i].low] = vertex_is_border[sides[i].high] = 1;
    for (; i < end; ++i) {
      edge_normals[sides[i].triangle][sides[i].opposite] = normal;
      edge_is_border[sides[i].triangle][sides[i].opposite] = is_border;
    }
  }
}

SurfaceDistance::Tree::Feature SurfaceDistance::Tree::feature_at(int triangle,
                                                                 const Vec3& weights) const {
  for (int i = 0; i < 3; ++i) {
    const int corner = mesh.triangles[triangle][i];
    if (weights[i] == 1) return {vertex_normals[corner], vertex_is_border[corner] != 0};
  }
  for (int i = 0; i < 3; ++i) {
    if (weights[i] == 0) return {edge_normals[triangle][i], edge_is_border[triangle][i] != 0};
  }
  return {face_normals[triangle], false};
}

SurfacePoint SurfaceDistance::Tree::describe(const Vec3& query, int triangle) const {
  const Triangle& corners = mesh.triangles[triangle];
  const Vec3& a = mesh.points[corners[0]];
  const Vec3& b = mesh.points[corners[1]];
  const Vec3& c = mesh.points[corners[2]];
  const Vec3 weights = closest_on_triangle(query, a, b, c);
  SurfacePoint found;
  found.point = weights[0] * a + weights[1] * b + weights[2] * c;
  const Feature feature = feature_at(triangle, weights);
  found.normal = feature.normal;
  found.triangle = triangle;
  const Vec3 away = query - found.point;
  found.distance = feature.border ? beside_border(away, feature.normal)
                                  : std::copysign(away.norm(), away.dot(feature.normal));
  return found;
}

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw Error("body", "has no triangles", "give a body mesh");
  tree_ = std::make_shared<const Tree>(mesh);
}

void SurfaceDistance::triangles_in_box(const Vec3& low, const Vec3& high,
                                       std::vector<int>& found) const {
  const CGAL::Bbox_3 box(low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  const std::size_t before = found.size();
  tree_->tree->meeting(low, high, found);
  const auto misses = [&](int triangle) {
    const Triangle& corners = tree_->mesh.triangles[triangle];
    return !CGAL::do_intersect(box, Kernel::Triangle_3(to_cgal(tree_->mesh.points[corners[0]]),
                                                       to_cgal(tree_->mesh.points[corners[1]]),
                                                       to_cgal(tree_->mesh.points[corners[2]])));
  };
  found.erase(
      std::remove_if(found.begin() + static_cast<std::ptrdiff_t>(before), found.end(), misses),
      found.end());
}

const TriangleMesh& SurfaceDistance::mesh() const { return tree_->mesh; }
const TriangleTree& SurfaceDistance::tree() const { return *tree_->tree; }

SurfacePoint SurfaceDistance::closest_point(const Vec3& query) const {
  return tree_->describe(query, tree_->tree->closest_triangle(query));
}

SurfacePoint SurfaceDistance::closest_point(const Vec3& query, const SurfacePoint& hint) const {
  return tree_->describe(query, tree_->tree->closest_triangle(query, hint.triangle));
}

void SurfaceDistance::closest_points(std::span<const Vec3> queries, const SurfacePoint& hint,
                                     SurfacePoint* found) const {
  std::array<int, TriangleTree::most_points> triangles;
  tree_->tree->closest_triangles(queries, hint.triangle, triangles.data());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    found[i] = tree_->describe(queries[i], triangles[i]);
  }
}

}  // namespace toile
