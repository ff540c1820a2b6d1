// The mannequin's solid in a pose: its parts move with their bones, and are joined as at rest.
#pragma once

#include <utility>

#include "geometry/body/mannequin/bend.h"
#include "geometry/body/mannequin/mannequin_shape.h"
#include "geometry/body/pose.h"
#include "geometry/body/skeleton.h"

namespace toile {

/// The mannequin's joints as it stands, metres, soles on y = 0.
const Skeleton& standing_joints();

/// What moves the parts of one limb pair of the left side; the right side is its mirror image.
class PosedSide {
 public:
  explicit PosedSide(const SidePose& pose);

  /// Where a point of a part at rest goes; and back.
  Vec3 leg(const Vec3& rest) const { return hip_.posed(knee_.posed(rest)); }
  Vec3 foot(const Vec3& rest) const { return leg(ankle_.posed(toes_.posed(rest))); }
  Vec3 arm(const Vec3& rest) const { return shoulder_.posed(elbow_.posed(rest)); }
  Vec3 leg_at_rest(const Vec3& posed) const { return knee_.rest(hip_.rest(posed)); }
  Vec3 foot_at_rest(const Vec3& leg) const { return toes_.rest(ankle_.rest(leg)); }
  Vec3 arm_at_rest(const Vec3& posed) const { return elbow_.rest(shoulder_.rest(posed)); }

  /// What moves the whole limb, its first bone as a rigid body.
  const Turn& hip() const { return hip_; }
  const Turn& shoulder() const { return shoulder_; }

  /// How a section of the leg, of the arm, is turned there.
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

/// The mannequin posed: the trunk stays where it is, so that soles need not be on y = 0. `shape`
/// has to outlive it.
class PosedMannequin {
 public:
  PosedMannequin(const MannequinShape& shape, const Pose& pose);

  /// About the distance to the skin; negative inside. A pose's mirror image has, to the last bit,
  /// the mirrored distances.
  double distance(const Vec3& point) const;

  Vec3 centre(const GirthTarget& target) const;
  Vec3 normal(const GirthTarget& target) const;
  Skeleton skeleton() const;
  /// Two corners of a box around the body, some centimetres wider; symmetric in x.
  std::pair<Vec3, Vec3> box() const;

 private:
  double leg(const PosedSide& side, const Vec3& point) const;
  double arm(const PosedSide& side, const Vec3& point) const;

  const MannequinShape& shape_;
  PosedSide left_;
  PosedSide right_;
};

}  // namespace toile
