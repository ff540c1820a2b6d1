// Forces of the in-plane terms and of bending, on one element at a time.
#pragma once

#include <cmath>

#include "cloth/program.h"

namespace toile {

/// How the stretch terms are to be taken, beyond the element's stiffnesses.
struct StretchOptions {
  double limit = -1;       ///< strain beyond which cloth stiffens; negative: none
  double compression = 1;  ///< share of the stiffness that resists compression
};

/// Forces on the corners of a triangle at a, b, c [Baraff & Witkin 1998, with strains
/// |w_u| - 1 and |w_v| - 1 and shear w_u·w_v]: minus the gradient of
/// E = area/2 (weft (|w_u|-1)² + warp (|w_v|-1)² + shear (w_u·w_v)²), and of the stiffening
/// beyond `limit` (negative: none).
inline std::array<Vec3, 3> stretch_forces(const StretchTriangle& s, const StretchOptions& options,
                                          const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 wu = s.weft[0] * a + s.weft[1] * b + s.weft[2] * c;
  const Vec3 wv = s.warp[0] * a + s.warp[1] * b + s.warp[2] * c;
  const double length_u = wu.norm();
  const double length_v = wv.norm();
  double stress_u = s.weft_stiffness * (length_u - 1);
  double stress_v = s.warp_stiffness * (length_v - 1);
  if (length_u < 1) stress_u *= options.compression;
  if (length_v < 1) stress_v *= options.compression;
  const double limit = options.limit;
  if (limit >= 0) {
    stress_u += strain_limit_stiffening * s.weft_stiffness * std::max(length_u - 1 - limit, 0.0);
    stress_v += strain_limit_stiffening * s.warp_stiffness * std::max(length_v - 1 - limit, 0.0);
  }
  const double shear = s.shear_stiffness * wu.dot(wv);
  // A direction crushed to nothing has no direction to push along.
  const double scale_u = length_u > 1e-9 ? stress_u / length_u : 0;
  const double scale_v = length_v > 1e-9 ? stress_v / length_v : 0;
  const Vec3 du = -(scale_u * wu + shear * wv);
  const Vec3 dv = -(scale_v * wv + shear * wu);
  return {s.weft[0] * du + s.warp[0] * dv, s.weft[1] * du + s.warp[1] * dv,
          s.weft[2] * du + s.warp[2] * dv};
}

/// Energy of the same, joules.
inline double stretch_energy(const StretchTriangle& s, double limit, const Vec3& a, const Vec3& b,
                             const Vec3& c) {
  const Vec3 wu = s.weft[0] * a + s.weft[1] * b + s.weft[2] * c;
  const Vec3 wv = s.warp[0] * a + s.warp[1] * b + s.warp[2] * c;
  const double u = wu.norm() - 1;
  const double v = wv.norm() - 1;
  const double shear = wu.dot(wv);
  double energy =
      s.weft_stiffness * u * u + s.warp_stiffness * v * v + s.shear_stiffness * shear * shear;
  if (limit >= 0) {
    const double over_u = std::max(u - limit, 0.0);
    const double over_v = std::max(v - limit, 0.0);
    energy += strain_limit_stiffening *
              (s.weft_stiffness * over_u * over_u + s.warp_stiffness * over_v * over_v);
  }
  return 0.5 * energy;
}

}  // namespace toile
