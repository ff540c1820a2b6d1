#include "cloth/springs/subject_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cloth/springs/constants.h"
#include "geometry/closest_points.h"
#include "geometry/error.h"

namespace toile {

namespace {

/// Sine of how far a direction may lean over a neighbour and still count as square to it: flat
/// meshes are flat to rounding only.
constexpr double lean = 1e-9;

const TriangleMesh& checked(const TriangleMesh& mesh) {
  for (const Vec3& p : mesh.points) {
    if (!p.allFinite()) {
      throw Error("subject surface", "has a point that is not finite", "give finite coordinates");
    }
  }
  return mesh;
}

}  // namespace

SubjectSurface::SubjectSurface(const TriangleMesh& mesh) : mesh_(checked(mesh)), distance_(mesh_) {
  facet_normals_.reserve(mesh.triangles.size());
  bool any = false;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 area =
        (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
    const double size = area.norm();
    facet_normals_.push_back(size > 1e-300 ? Vec3(area / size) : Vec3::Zero());
    any = any || size > 1e-300;
  }
  if (!any) throw Error("subject surface", "has no triangle with an area", "give a surface");
  build_edges();
  build_vertices();
}

void SubjectSurface::build_edges() {
  facet_edges_.assign(mesh_.triangles.size(), {-1, -1, -1});
  owned_.assign(mesh_.triangles.size(), 0);
  std::map<std::pair<int, int>, int> numbers;
  std::vector<int> uses;
  for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
    if (facet_normals_[t].isZero()) continue;
    const Triangle& corners = mesh_.triangles[t];
    for (int side = 0; side < 3; ++side) {
      const int a = corners[side];
      const int b = corners[(side + 1) % 3];
      const auto [found, is_new] =
          numbers.try_emplace(std::minmax(a, b), static_cast<int>(edges_.size()));
      if (is_new) {
        edges_.push_back({.a = std::min(a, b), .b = std::max(a, b)});
        uses.push_back(0);
        owned_[t] |= static_cast<unsigned char>(1U << side);
      }
      facet_edges_[t][side] = found->second;
      SubjectEdge& edge = edges_[found->second];
      edge.normal += facet_normals_[t];
      const int use = uses[found->second]++;
      if (use < 2) {
        edge.facets[use] = t;
        edge.inward[use] = facet_normals_[t].cross(mesh_.points[b] - mesh_.points[a]).normalized();
      }
    }
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    SubjectEdge& edge = edges_[e];
    edge.rim = uses[e] != 2;
    edge.ridge = edge.rim || facet_normals_[edge.facets[0]].dot(edge.inward[1]) < -lean;
    const double size = edge.normal.norm();
    edge.normal = size > 0 ? Vec3(edge.normal / size) : facet_normals_[edge.facets[0]];
  }
}

void SubjectSurface::build_vertices() {
  const std::size_t count = mesh_.points.size();
  vertex_normals_.assign(count, Vec3::Zero());
  side_normals_.assign(count, Vec3::Zero());
  vertex_on_rim_.assign(count, 0);
  std::vector<char> owned(count, 0);
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (facet_normals_[t].isZero()) continue;
    const Triangle& corners = mesh_.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const int here = corners[i];
      const Vec3 u = mesh_.points[corners[(i + 1) % 3]] - mesh_.points[here];
      const Vec3 v = mesh_.points[corners[(i + 2) % 3]] - mesh_.points[here];
      vertex_normals_[here] += facet_normals_[t];
      side_normals_[here] += std::atan2(u.cross(v).norm(), u.dot(v)) * facet_normals_[t];
      if (owned[here] == 0) owned_[t] |= static_cast<unsigned char>(8U << i);
      owned[here] = 1;
    }
  }
  for (Vec3& normal : vertex_normals_) normal.normalize();
  for (Vec3& normal : side_normals_) normal.normalize();
  for (const SubjectEdge& edge : edges_) {
    if (edge.rim) vertex_on_rim_[edge.a] = vertex_on_rim_[edge.b] = 1;
  }
  ring_.assign(count, [&](const auto& add) {
    for (const SubjectEdge& edge : edges_) {
      add(edge.a, edge.b);
      add(edge.b, edge.a);
    }
  });
  vertex_is_tip_.assign(count, 0);
  for (std::size_t v = 0; v < count; ++v) {
    vertex_is_tip_[v] = owned[v] != 0 && find_tip(static_cast<int>(v)) ? 1 : 0;
  }
}

bool SubjectSurface::find_tip(int vertex) const {
  if (on_rim(vertex)) return true;
  // A direction that leads away from all edges, by turning it off the worst until there is none.
  Vec3 direction = side_normals_[vertex];
  for (int turn = 0; turn < 100; ++turn) {
    double worst = 1e-6;
    Vec3 off = Vec3::Zero();
    for (const int other : neighbours(vertex)) {
      const Vec3 along = (point(other) - point(vertex)).normalized();
      if (direction.dot(along) > worst) {
        worst = direction.dot(along);
        off = along;
      }
    }
    // All edges may lead away from a direction into the body, too: a pit.
    if (off.isZero(0)) return direction.dot(side_normals_[vertex]) > 0;
    direction = (direction - 1.5 * worst * off).normalized();
  }
  return false;
}

double SubjectSurface::distance(const Vec3& p) const {
  return std::abs(distance_.closest_point(p).distance);
}

void SubjectSurface::facets_in_box(const Vec3& low, const Vec3& high,
                                   std::vector<int>& found) const {
  found.clear();
  distance_.triangles_in_box(low, high, found);
  std::erase_if(found, [&](int facet) { return facet_normals_[facet].isZero(); });
  std::sort(found.begin(), found.end());
}

bool SubjectSurface::faces(const SubjectEdge& edge, const Vec3& direction) const {
  return direction.dot(edge.inward[0]) <= lean && direction.dot(edge.inward[1]) <= lean;
}

bool SubjectSurface::faces(int vertex, const Vec3& direction) const {
  const Vec3& here = point(vertex);
  for (const int other : neighbours(vertex)) {
    const Vec3 along = point(other) - here;
    if (direction.dot(along) > lean * along.norm()) return false;
  }
  return true;
}

SubjectNearest SubjectSurface::at_edge(const Vec3& p, const Vec3& point,
                                       const SubjectEdge& edge) const {
  const Vec3 away = p - point;
  const double size = away.norm();
  if (size < touching) return {point, 0, edge.normal, true};
  const Vec3 direction = away / size;
  const bool local = faces(edge, direction);
  if (edge.rim || direction.dot(edge.normal) >= 0) return {point, size, direction, local};
  return {point, -size, -direction, local};
}

SubjectNearest SubjectSurface::at_vertex(const Vec3& p, int vertex) const {
  const Vec3& point = this->point(vertex);
  const Vec3 away = p - point;
  const double size = away.norm();
  if (size < touching) return {point, 0, vertex_normals_[vertex], true};
  const Vec3 direction = away / size;
  const bool local = faces(vertex, direction);
  if (on_rim(vertex) || direction.dot(side_normals_[vertex]) >= 0) {
    return {point, size, direction, local};
  }
  return {point, -size, -direction, local};
}

SubjectNearest SubjectSurface::nearest(const Vec3& p, int facet) const {
  const Triangle& t = mesh_.triangles[facet];
  const Vec3 weights = closest_on_triangle(p, point(t[0]), point(t[1]), point(t[2]));
  for (int i = 0; i < 3; ++i) {
    if (weights[i] == 1) return at_vertex(p, t[i]);
  }
  const Vec3 on = weights[0] * point(t[0]) + weights[1] * point(t[1]) + weights[2] * point(t[2]);
  for (int i = 0; i < 3; ++i) {
    if (weights[i] == 0) return at_edge(p, on, edges_[facet_edges_[facet][(i + 1) % 3]]);
  }
  const Vec3& normal = facet_normals_[facet];
  return {on, (p - point(t[0])).dot(normal), normal, true};
}

}  // namespace toile
