#include "geometry/body_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/error.h"
#include "geometry/nearest.h"

namespace toile {

namespace {

// Distances need no exact predicates, and the plain kernel is 15-35 % faster.
using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

double corner_angle(const Vec3& at, const Vec3& to, const Vec3& also_to) {
  const Vec3 u = to - at;
  const Vec3 v = also_to - at;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// The signed distance at `away` from the nearest point, on a border whose sheet faces `normal`.
double beside_border(const Vec3& away, const Vec3& normal) {
  const double distance = away.norm();
  const double behind = -away.dot(normal);
  if (behind <= 0) return distance;
  const double beyond = std::sqrt(std::max(0.0, distance * distance - behind * behind));
  const double zero = std::min(behind, BodyDistance::border_bevel);
  return distance * (beyond - zero) / (beyond + zero);
}

}  // namespace

struct BodyDistance::Tree {
  TriangleMesh body;
  Triangles triangles;
  AabbTree aabb;
  std::vector<Vec3> face_normals;
  std::vector<std::array<Vec3, 3>> edge_normals;  // of the edge opposite to corner i
  std::vector<Vec3> vertex_normals;
  std::vector<std::array<char, 3>> edge_is_border;
  std::vector<char> vertex_is_border;

  /// What the nearest point of a triangle lies on.
  struct Feature {
    Vec3 normal;
    bool border;
  };
  void compute_normals();
  Feature feature_at(int triangle, const Vec3& weights) const;
  BodyPoint describe(const Vec3& query, int triangle) const;
};

void BodyDistance::Tree::compute_normals() {
  face_normals.resize(body.triangles.size());
  edge_normals.resize(body.triangles.size());
  vertex_normals.assign(body.points.size(), Vec3::Zero());
  vertex_is_border.assign(body.points.size(), 0);
  edge_is_border.resize(body.triangles.size());
  struct Edge {
    Vec3 normal = Vec3::Zero();
    int triangles = 0;
  };
  std::map<std::pair<int, int>, Edge> across;
  const auto edge_key = [](int a, int b) { return std::pair(std::min(a, b), std::max(a, b)); };
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    const Triangle& corners = body.triangles[t];
    const Vec3& a = body.points[corners[0]];
    const Vec3& b = body.points[corners[1]];
    const Vec3& c = body.points[corners[2]];
    face_normals[t] = (b - a).cross(c - a).normalized();
    for (int i = 0; i < 3; ++i) {
      const int here = corners[i];
      const int next = corners[(i + 1) % 3];
      const int last = corners[(i + 2) % 3];
      vertex_normals[here] +=
          corner_angle(body.points[here], body.points[next], body.points[last]) * face_normals[t];
      Edge& edge = across[edge_key(next, last)];
      edge.normal += face_normals[t];
      ++edge.triangles;
    }
  }
  for (Vec3& normal : vertex_normals) normal.normalize();
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    const Triangle& corners = body.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const int next = corners[(i + 1) % 3];
      const int last = corners[(i + 2) % 3];
      const Edge& edge = across.at(edge_key(next, last));
      edge_normals[t][i] = edge.normal.normalized();
      edge_is_border[t][i] = edge.triangles == 1;
      if (edge.triangles == 1) vertex_is_border[next] = vertex_is_border[last] = 1;
    }
  }
}

BodyDistance::Tree::Feature BodyDistance::Tree::feature_at(int triangle,
                                                           const Vec3& weights) const {
  for (int i = 0; i < 3; ++i) {
    const int corner = body.triangles[triangle][i];
    if (weights[i] == 1) return {vertex_normals[corner], vertex_is_border[corner] != 0};
  }
  for (int i = 0; i < 3; ++i) {
    if (weights[i] == 0) return {edge_normals[triangle][i], edge_is_border[triangle][i] != 0};
  }
  return {face_normals[triangle], false};
}

BodyPoint BodyDistance::Tree::describe(const Vec3& query, int triangle) const {
  const Triangle& corners = body.triangles[triangle];
  const Vec3& a = body.points[corners[0]];
  const Vec3& b = body.points[corners[1]];
  const Vec3& c = body.points[corners[2]];
  const Vec3 weights = nearest_on_triangle(query, a, b, c);
  BodyPoint found;
  found.point = weights[0] * a + weights[1] * b + weights[2] * c;
  const Feature feature = feature_at(triangle, weights);
  found.normal = feature.normal;
  found.triangle = triangle;
  const Vec3 away = query - found.point;
  found.distance = feature.border ? beside_border(away, feature.normal)
                                  : std::copysign(away.norm(), away.dot(feature.normal));
  return found;
}

BodyDistance::BodyDistance(const TriangleMesh& body) : tree_(std::make_unique<Tree>()) {
  if (body.triangles.empty()) throw Error("body", "has no triangles", "give a body mesh");
  tree_->body = body;
  tree_->triangles.reserve(body.triangles.size());
  for (const Triangle& t : body.triangles) {
    tree_->triangles.emplace_back(to_cgal(body.points[t[0]]), to_cgal(body.points[t[1]]),
                                  to_cgal(body.points[t[2]]));
  }
  tree_->aabb.rebuild(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->compute_normals();
  // Both are built on first use otherwise, which threads must not race for.
  tree_->aabb.build();
  tree_->aabb.accelerate_distance_queries();
}

BodyDistance::~BodyDistance() = default;
BodyDistance::BodyDistance(BodyDistance&&) noexcept = default;
BodyDistance& BodyDistance::operator=(BodyDistance&&) noexcept = default;

void BodyDistance::triangles_in_box(const Vec3& low, const Vec3& high,
                                    std::vector<int>& found) const {
  std::vector<Triangles::const_iterator> met;
  tree_->aabb.all_intersected_primitives(
      CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()),
      std::back_inserter(met));
  for (const auto& triangle : met) {
    found.push_back(static_cast<int>(triangle - tree_->triangles.cbegin()));
  }
}

const TriangleMesh& BodyDistance::body() const { return tree_->body; }

BodyPoint BodyDistance::nearest(const Vec3& query) const {
  const auto found = tree_->aabb.closest_point_and_primitive(to_cgal(query));
  return tree_->describe(query, static_cast<int>(found.second - tree_->triangles.cbegin()));
}

BodyPoint BodyDistance::nearest(const Vec3& query, const BodyPoint& hint) const {
  const auto found = tree_->aabb.closest_point_and_primitive(
      to_cgal(query), {to_cgal(hint.point), tree_->triangles.cbegin() + hint.triangle});
  return tree_->describe(query, static_cast<int>(found.second - tree_->triangles.cbegin()));
}

}  // namespace toile
