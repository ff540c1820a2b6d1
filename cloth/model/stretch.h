// Forces of the in-plane terms on one triangle at a time.
#pragma once

#include <cmath>

#include "cloth/model/garment_model.h"

namespace toile {

/// Limits and compression of the stretch terms.
struct StretchOptions {
  double limit = -1;        ///< largest strain of warp and weft; negative: no limit
  double compression = 1;   ///< share of the stiffness that acts in compression
  double shear_limit = -1;  ///< largest |w_u·w_v|; negative: no limit
};

/// N/m: Lagrange multipliers that hold a triangle to its limits, in addition to its own stress.
struct LimitMultiplier {
  double weft = 0;   ///< never negative
  double warp = 0;   ///< never negative
  double shear = 0;  ///< of the sign of w_u·w_v
};

/// N: forces on the corners of a triangle at a, b, c [Baraff & Witkin 1998]. w_u and w_v are
/// the weft's and the warp's unit vectors as deformed. Strains are |w_u| - 1 and |w_v| - 1, shear
/// is w_u·w_v. The forces are minus the gradient of E = area/2 (weft (|w_u|-1)² + warp (|w_v|-1)² +
/// shear (w_u·w_v)²).
///
/// - A negative strain counts with `options.compression` times its stiffness.
/// - Beyond a limit of `options`, `strain_limit_stiffening` times the stiffness is added. It acts
///   the earlier, the larger the `multiplier` is [augmented Lagrangian: Nocedal & Wright 2006,
///   17.4].
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
    // A yarn that is crushed to nothing has no direction to push along.
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

}  // namespace toile
