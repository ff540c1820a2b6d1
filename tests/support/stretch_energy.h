// The energy whose gradient stretch_forces() is, written independently of it.
#pragma once

#include <algorithm>

#include "cloth/model/stretch.h"
#include "cloth/scene/constants.h"

namespace toile {

/// Joules: the stretch and shear energy of a triangle at a, b, c, without multipliers, compression
/// share or shear limit. `limit` is the strain limit of weft and warp; negative: none.
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
