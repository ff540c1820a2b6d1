// The area of a triangle in space.
#pragma once

#include <Eigen/Geometry>

#include "geometry/types.h"

namespace toile {

/// m², of corners in metres.
inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

}  // namespace toile
