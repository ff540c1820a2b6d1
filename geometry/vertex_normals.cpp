#include "geometry/vertex_normals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace toile {

std::vector<Vec3> vertex_normals(const std::vector<Vec3>& points,
                                 const std::vector<Triangle>& triangles) {
  std::vector<Vec3> normals(points.size(), Vec3::Zero());
  for (const Triangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& at = points[triangle[k]];
      const Vec3 to_next = points[triangle[(k + 1) % 3]] - at;
      const Vec3 to_last = points[triangle[(k + 2) % 3]] - at;
      const Vec3 across = to_next.cross(to_last);
      const double size = across.norm();
      if (size > 0) {
        normals[triangle[k]] += std::atan2(size, to_next.dot(to_last)) / size * across;
      }
    }
  }
  for (Vec3& normal : normals) {
    const double size = normal.norm();
    normal = size > 0 ? Vec3(normal / size) : Vec3::UnitY();
  }
  return normals;
}

}  // namespace toile
