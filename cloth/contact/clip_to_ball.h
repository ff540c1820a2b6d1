// Clips a displacement to a ball.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/types.h"

namespace toile {

/// Largest share in [0, 1] of `displacement` that keeps `away` + share · `displacement` within a
/// ball of `radius` metres around the origin. `away` is inside the ball, up to rounding.
inline double clip_to_ball(const Vec3& away, const Vec3& displacement, double radius) {
  const double a = displacement.squaredNorm();
  if (a == 0 || (away + displacement).norm() <= radius) return 1;
  const double b = away.dot(displacement);
  const double c = std::min(away.squaredNorm() - radius * radius, 0.0);
  // Slightly less: the root itself may round to the outside.
  return std::clamp((std::sqrt(b * b - a * c) - b) / a * (1 - 1e-9), 0.0, 1.0);
}

}  // namespace toile
