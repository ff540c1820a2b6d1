// Small meshes with known answers.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/types.h"

namespace toile::test {

/// Unit cube [0, 1]³, outward, 12 triangles.
inline TriangleMesh cube() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Sphere around the origin: an octahedron split `levels` times, vertices on the sphere.
inline TriangleMesh sphere(double radius, int levels) {
  TriangleMesh mesh;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.points.size()));
      if (is_new) mesh.points.push_back((mesh.points[a] + mesh.points[b]).normalized());
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const int m01 = middle(t[0], t[1]);
      const int m12 = middle(t[1], t[2]);
      const int m20 = middle(t[2], t[0]);
      finer.insert(finer.end(),
                   {{t[0], m01, m20}, {m01, t[1], m12}, {m20, m12, t[2]}, {m01, m12, m20}});
    }
    mesh.triangles = finer;
  }
  for (Vec3& p : mesh.points) p *= radius;
  return mesh;
}

/// A box from `low` to `high`, outward, 12 triangles.
inline TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh = cube();
  for (Vec3& p : mesh.points) p = low + p.cwiseProduct(high - low);
  return mesh;
}

/// Both meshes in one, not joined.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  append(a, b);
  return a;
}

/// A pyramid on the square of half width `half` around (x, z), from below y = 0 up to `height`.
inline TriangleMesh spike(double x, double z, double half, double height) {
  TriangleMesh mesh;
  mesh.points = {{x - half, -0.01, z - half},
                 {x - half, -0.01, z + half},
                 {x + half, -0.01, z + half},
                 {x + half, -0.01, z - half},
                 {x, height, z}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

/// The same surface, facing the other way.
inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// The same triangles as a mesh file would give them.
inline PolygonSoup soup(const TriangleMesh& mesh) {
  PolygonSoup polygons;
  polygons.points = mesh.points;
  for (const Triangle& t : mesh.triangles) polygons.polygons.push_back({t[0], t[1], t[2]});
  return polygons;
}

/// Enclosed volume, positive for an outward-oriented closed mesh.
inline double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6;
  }
  return sum;
}

/// Whether each edge has exactly two triangles, which pass it in opposite directions.
inline bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (++uses[{t[i], t[(i + 1) % 3]}] > 1) return false;
    }
  }
  for (const auto& [edge, count] : uses) {
    if (!uses.contains({edge.second, edge.first})) return false;
  }
  return !mesh.triangles.empty();
}

}  // namespace toile::test
