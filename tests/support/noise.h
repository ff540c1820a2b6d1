// A surface as a noisy scanner would have it.
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "geometry/types.h"

namespace toile::test {

/// The surface with its points moved along their normals, by a deviation of 1 mm.
inline TriangleMesh noisy(TriangleMesh mesh, unsigned seed) {
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.points[t[0]];
    const Vec3 normal = (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a);
    for (const int i : t) normals[i] += normal;
  }
  std::mt19937 random(seed);
  std::normal_distribution<double> millimetre(0, 0.001);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    mesh.points[i] += millimetre(random) * normals[i].normalized();
  }
  return mesh;
}

}  // namespace toile::test
