// How the bones of a standing body move into a pose.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "geometry/body/pose.h"
#include "geometry/body/skeleton.h"
#include "geometry/body/skin_cores.h"
#include "geometry/types.h"

namespace toile {

/// A rigid motion: p goes to turn * p + shift.
struct RigidMotion {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Vec3 shift = Vec3::Zero();  ///< metres

  /// The turn about a joint, which stays.
  static RigidMotion about(const Vec3& joint, const Eigen::Quaterniond& turn) {
    return {turn, joint - turn * joint};
  }
  Vec3 operator()(const Vec3& p) const { return turn * p + shift; }
  /// The motion that does `first`, then this.
  RigidMotion operator*(const RigidMotion& first) const {
    return {turn * first.turn, turn * first.shift + shift};
  }
};

/// The motion of an upper arm or a thigh. Its turn about its own length grows from none at the
/// upper joint to all at the lower one. So the skin is not wrung at the joint.
struct UpperBone {
  Vec3 joint = Vec3::Zero();   ///< metres: shoulder or hip
  Vec3 along = Vec3::UnitY();  ///< unit vector down the standing limb
  double length = 1;           ///< metres
  Eigen::Quaterniond swing;    ///< without the turn about the bone
  double twist = 0;            ///< radians about `along`, before the swing

  /// The motion of the skin at a point of the standing body.
  RigidMotion at(const Vec3& p) const;
  /// The motion of the bone's lower end.
  RigidMotion end() const;
};

/// The bones of one side. Each moves with those before it.
struct SideMotion {
  UpperBone upper_arm;
  UpperBone thigh;
  RigidMotion forearm;
  RigidMotion shin;
  RigidMotion foot;
  RigidMotion toes;
};

/// The motion of one side into a pose. The trunk stays.
///
/// The upper arm's flexion and abduction are those of its bone, from hanging straight down. All
/// other angles are counted from the body as it stands. The elbow bends forward, square to the arm.
/// The skeleton has all of joint_names.
SideMotion side_motion(const Skeleton& skeleton, const FootShape& foot, const SidePose& pose,
                       bool left);

/// The joints, moved with their bones. Bones keep their lengths.
Skeleton moved(Skeleton skeleton, const std::array<SideMotion, 2>& sides);

}  // namespace toile
