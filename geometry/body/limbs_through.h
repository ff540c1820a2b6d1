// Which limbs of a body pass through a closed curve, such as the hem or the neck of a garment.
#pragma once

#include <vector>

#include "geometry/body/skeleton.h"

namespace toile {

/// The limbs on the other side of a closed curve from the head. A cuff has one arm, a hem at the
/// hips both legs, a neckline all four. None: nothing passes through the curve.
struct LimbsThrough {
  bool left_arm = false;
  bool right_arm = false;
  bool left_leg = false;
  bool right_leg = false;

  bool operator==(const LimbsThrough&) const = default;
  bool any() const { return left_arm || right_arm || left_leg || right_leg; }
};

inline constexpr LimbsThrough through_neckline{true, true, true, true};
inline constexpr LimbsThrough through_hem{false, false, true, true};

/// Share of the way from neck to crown at which the face looks out: a standing collar ends below.
inline constexpr double middle_of_face = 0.6;

/// Whether the skeleton has all joints of joint_names, as limbs_through() needs.
bool has_all_limbs(const Skeleton& skeleton);

/// By linking numbers, so the curve's shape plays no part. The curve must not meet the body.
///
/// Each limb is its bones from the waist, extended to infinity. A leg goes straight down. An arm
/// goes on by a hand's length and then sideways. The head goes forward, so that it passes through
/// the opening of a hood, from the share `face` of the way from neck to crown.
/// `loop` is a closed polyline in metres, its last point joined to the first. The skeleton has all
/// limbs. Throws Error when one is missing. Linear in the points.
LimbsThrough limbs_through(const std::vector<Vec3>& loop, const Skeleton& skeleton,
                           double face = middle_of_face);

}  // namespace toile
