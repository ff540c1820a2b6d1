// Forces of the in-plane terms and of bending, on one element at a time.
#pragma once

#include <cmath>

#include "cloth/model/garment_model.h"

namespace toile {

/// How the stretch terms are to be taken, beyond the element's stiffnesses.
struct StretchOptions {
  double limit = -1;        ///< strain that warp and weft are multipliers to; negative: none
  double compression = 1;   ///< share of the stiffness that resists compression
  double shear_limit = -1;  ///< likewise of |w_u·w_v|
};

/// What holds a triangle to its limits, besides its own stress, N/m: a Lagrange multiplier.
struct LimitMultiplier {
  double weft = 0;   ///< never negative
  double warp = 0;   ///< never negative
  double shear = 0;  ///< of the sign of w_u·w_v
};

/// Forces on the corners of a triangle at a, b, c [Baraff & Witkin 1998, with strains
/// |w_u| - 1 and |w_v| - 1 and shear w_u·w_v]: minus the gradient of
/// E = area/2 (weft (|w_u|-1)² + warp (|w_v|-1)² + shear (w_u·w_v)²), and of the stiffening
/// beyond the limits, which begins earlier the more `multipliers` holds [augmented Lagrangian:
/// Nocedal & Wright 2006, 17.4].
inline std::array<Vec3, 3> stretch_forces(const StretchTriangle& s, const StretchOptions& options,
                                          const Vec3& a, const Vec3& b, const Vec3& c,
                                          const LimitMultiplier& multiplier = {}) {
  const Vec3 wu = s.weft[0] * a + s.weft[1] * b + s.weft[2] * c;
  const Vec3 wv = s.warp[0] * a + s.warp[1] * b + s.warp[2] * c;
  const auto over = [](double stiffness, double by, double hold) {
    return std::max(hold + strain_limit_stiffening * stiffness * by, 0.0);
  };
  const auto along = [&](double stiffness, double length, double hold) {
    const double strain = length - 1;
    double stress = stiffness * (strain < 0 ? options.compression : 1) * strain;
    if (options.limit >= 0) stress += over(stiffness, strain - options.limit, hold);
    // A direction crushed to nothing has no direction to push along.
    return length > 1e-9 ? stress / length : 0;
  };
  const double scale_u = along(s.weft_stiffness, wu.norm(), s.area * multiplier.weft);
  const double scale_v = along(s.warp_stiffness, wv.norm(), s.area * multiplier.warp);
  const double turned = wu.dot(wv);
  double shear = s.shear_stiffness * turned;
  if (const double limit = options.shear_limit; limit >= 0) {
    shear += over(s.shear_stiffness, turned - limit, s.area * multiplier.shear) -
             over(s.shear_stiffness, -turned - limit, -s.area * multiplier.shear);
  }
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
