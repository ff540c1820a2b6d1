// The plane between the legs.
#pragma once

#include "geometry/body/skeleton.h"

namespace toile {

/// The plane half-way between the hips, square to the line through them.
struct LegDivide {
  Vec3 at = Vec3::Zero();    ///< metres
  Vec3 left = Vec3::Zero();  ///< unit vector toward the left leg

  /// Metres to the left of the plane.
  double beside(const Vec3& p) const { return (p - at).dot(left); }
};

/// Throws Error when the skeleton has no hips.
inline LegDivide leg_divide(const Skeleton& skeleton) {
  const Vec3& left = skeleton.joint("left_hip");
  const Vec3& right = skeleton.joint("right_hip");
  return {0.5 * (left + right), (left - right).normalized()};
}

}  // namespace toile
