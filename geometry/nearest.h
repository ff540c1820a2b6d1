// Nearest points of the simple figures: a triangle, two segments.
#pragma once

#include <utility>

#include "geometry/types.h"

namespace toile {

/// Barycentric weights of the point of triangle abc nearest to p [Ericson 2005, Real-Time Collision
/// Detection, 5.1.5]. Weights that are exactly 0 tell that it lies on an edge or a corner.
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Parameters (s, t) in [0, 1] of the points a + s(b-a) and c + t(d-c) nearest to each other
/// [Ericson 2005, 5.1.9]. Of parallel segments, one of the nearest pairs.
std::pair<double, double> nearest_on_segments(const Vec3& a, const Vec3& b, const Vec3& c,
                                              const Vec3& d);

}  // namespace toile
