// Closest points on a segment, on a triangle and on two segments.
#pragma once

#include <algorithm>
#include <utility>

#include "geometry/types.h"

namespace toile {

/// Share in [0, 1] of the way from a to b of the segment's point closest to p, in two dimensions or
/// three. 0 for a segment without length.
template <typename Vec>
double closest_on_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec along = b - a;
  const double square = along.squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
}

/// Barycentric weights of the point of triangle abc closest to p [Ericson 2005, Real-Time Collision
/// Detection, 5.1.5]. A point on an edge has one weight of exactly 0, one in a corner has two.
inline Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

/// Parameters (s, t) in [0, 1] of the points a + s(b-a) and c + t(d-c) closest to each other
/// [Ericson 2005, 5.1.9]. Parallel segments have many closest pairs; it returns one of them.
inline std::pair<double, double> closest_on_segments(const Vec3& a, const Vec3& b, const Vec3& c,
                                                     const Vec3& d) {
  const Vec3 u = b - a;
  const Vec3 v = d - c;
  const Vec3 r = a - c;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double uv = u.dot(v);
  const double ur = u.dot(r);
  const double vr = v.dot(r);
  if (uu == 0 && vv == 0) return {0, 0};
  if (uu == 0) return {0, std::clamp(vr / vv, 0.0, 1.0)};
  if (vv == 0) return {std::clamp(-ur / uu, 0.0, 1.0), 0};
  const double denominator = uu * vv - uv * uv;
  // For nearly parallel segments any s will do; it takes 0.
  double s =
      denominator > 1e-12 * uu * vv ? std::clamp((uv * vr - ur * vv) / denominator, 0.0, 1.0) : 0.0;
  double t = (uv * s + vr) / vv;
  if (t < 0) {
    t = 0;
    s = std::clamp(-ur / uu, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((uv - ur) / uu, 0.0, 1.0);
  }
  return {s, t};
}

}  // namespace toile
