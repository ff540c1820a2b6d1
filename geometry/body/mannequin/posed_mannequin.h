// The mannequin's solid in a pose. Its parts move with their bones and are joined as at rest.
#pragma once

#include <utility>

#include "geometry/body/mannequin/bend.h"
#include "geometry/body/mannequin/mannequin_bones.h"
#include "geometry/body/mannequin/mannequin_shape.h"
#include "geometry/body/pose.h"
#include "geometry/body/skeleton.h"

namespace toile {

/// The motion of the left side's arm and leg. The right side is its mirror image.
class PosedSide {
 public:
  PosedSide(const SidePose& pose, const MannequinBones& bones);

  /// The posed place of a point of a part at rest.
  Vec3 leg(const Vec3& rest) const { return hip_.posed(knee_.posed(rest)); }
  Vec3 foot(const Vec3& rest) const { return leg(ankle_.posed(toes_.posed(rest))); }
  Vec3 arm(const Vec3& rest) const { return shoulder_.posed(elbow_.posed(rest)); }
  /// The place at rest of a posed point. foot_at_rest() takes the result of leg_at_rest().
  Vec3 leg_at_rest(const Vec3& posed) const { return knee_.rest(hip_.rest(posed)); }
  Vec3 foot_at_rest(const Vec3& leg) const { return toes_.rest(ankle_.rest(leg)); }
  Vec3 arm_at_rest(const Vec3& posed) const { return elbow_.rest(shoulder_.rest(posed)); }

  /// The turn of the whole limb, and of its first bone as a rigid body.
  const Turn& hip() const { return hip_; }
  const Turn& shoulder() const { return shoulder_; }

  /// The rotation of the leg's or the arm's section at a point at rest.
  Eigen::Matrix3d leg_turn(const Vec3& rest) const { return hip_.rotation * knee_.turn(rest); }
  Eigen::Matrix3d arm_turn(const Vec3& rest) const {
    return shoulder_.rotation * elbow_.turn(rest);
  }

 private:
  Turn hip_;
  Bend knee_;
  Turn ankle_;
  Bend toes_;
  Turn shoulder_;
  Bend elbow_;
};

/// The posed mannequin, metres. The trunk stays in its place, so the soles may leave y = 0. `shape`
/// has to outlive it.
class PosedMannequin {
 public:
  PosedMannequin(const MannequinShape& shape, const Pose& pose);

  /// About the distance to the skin, negative inside. The mirror image of a pose has the mirrored
  /// distances to the last bit.
  double distance(const Vec3& point) const;

  /// The posed centre and normal of the girth's plane, on the left side for limbs.
  Vec3 centre(const GirthTarget& target) const;
  Vec3 normal(const GirthTarget& target) const;
  Skeleton skeleton() const;
  /// The lower and upper corner of a box some centimetres wider than the body. It is symmetric in
  /// x.
  std::pair<Vec3, Vec3> box() const;

 private:
  double leg(const PosedSide& side, const Vec3& point) const;
  double arm(const PosedSide& side, const Vec3& point) const;

  const MannequinShape& shape_;
  PosedSide left_;
  PosedSide right_;
};

}  // namespace toile
