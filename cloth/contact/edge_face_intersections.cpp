#include "cloth/contact/edge_face_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "cloth/contact/constants.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// Where a segment passes through a triangle: its share from a to b, and the corners' weights.
struct Pierced {
  double share;
  Vec3 corners;
};

std::optional<Pierced> pierced(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double from = normal.dot(a - t[0]);
  const double to = normal.dot(b - t[0]);
  if (from * to > 0 || from == to) return std::nullopt;
  const double share = from / (from - to);
  const Vec3 p = a + share * (b - a);
  const double area = normal.squaredNorm();
  Vec3 weights;
  for (int i = 0; i < 3; ++i) {
    const Vec3& u = t[(i + 1) % 3];
    const Vec3& v = t[(i + 2) % 3];
    weights[i] = normal.dot((v - u).cross(p - u)) / area;
  }
  if (weights.minCoeff() < 0) return std::nullopt;
  return Pierced{share, weights};
}

}  // namespace

std::vector<EdgeFaceIntersection> find_edge_face_intersections(
    const std::vector<Vec3>& x, const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::array<int, 2>, int>, EdgeFaceIntersection> found;
  const auto consider = [&](int through, int pierced_face) {
    const Triangle& sheet = triangles[through];
    const Triangle& face = triangles[pierced_face];
    const std::array<Vec3, 3> corners = {x[face[0]], x[face[1]], x[face[2]]};
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (int i = 0; i < 3; ++i) {
      int a = sheet[i];
      int b = sheet[(i + 1) % 3];
      if (a > b) std::swap(a, b);
      if (std::ranges::find(face, a) != face.end() || std::ranges::find(face, b) != face.end()) {
        continue;
      }
      const auto hit = pierced(x[a], x[b], corners);
      if (!hit) continue;
      const Vec3 along = (x[b] - x[a]).normalized();
      const Vec3 other = x[sheet[(i + 2) % 3]] - x[a];
      const Vec3 inward = other - other.dot(along) * along;
      const Vec3 own = (x[b] - x[a]).cross(other);
      Vec3 line = normal.cross(own);
      if (line.squaredNorm() == 0) continue;
      line.normalize();
      if (line.dot(inward) < 0) line = -line;
      // The end of the line slides along the edge to stay in the face.
      const double slant = along.dot(normal);
      const double steep = std::copysign(std::max(std::abs(slant), min_crossing_slant), slant);
      const Vec3 way = line - along.dot(line) / steep * normal;
      EdgeFaceIntersection& crossing = found[{{a, b}, pierced_face}];
      crossing.edge = {a, b};
      crossing.face = face;
      crossing.weights = {1 - hit->share, hit->share, hit->corners[0], hit->corners[1],
                          hit->corners[2]};
      crossing.way = crossing.way + way;
    }
  };
  for (const auto& [s, t] : self_intersections({x, triangles})) {
    consider(s, t);
    consider(t, s);
  }
  std::vector<EdgeFaceIntersection> all;
  all.reserve(found.size());
  for (auto& [where, crossing] : found) all.push_back(crossing);
  return all;
}

}  // namespace toile
