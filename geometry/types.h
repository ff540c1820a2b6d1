// The plain data that all parts of Toile share: points, triangles, polygon soups.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace toile {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// Three point indices, counter-clockwise as seen from outside.
using Triangle = std::array<int, 3>;

/// A triangle mesh in metres. Every index in `triangles` is in [0, points.size()).
struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// Appends the points and triangles of `more` to `mesh`; O(size of `more`).
inline void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
  for (const Triangle& t : more.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

/// The unchecked content of a mesh file: polygons of any size in any order, in the file's unit.
/// Every index is in [0, points.size()).
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> polygons;
};

}  // namespace toile
