#include "geometry/body/bone_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "geometry/angles.h"

namespace toile {

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;

/// Shares of the bone's length between which its twist grows.
constexpr double twist_from = 0.1;
constexpr double twist_to = 0.9;
/// An arm that points straight to the side, up to 14 degrees, has no flexion.
constexpr double arm_sideways = 0.97;

Quaterniond turn_about(const Vec3& axis, double degrees) {
  return Quaterniond(AngleAxisd(degrees * radians_per_degree, axis));
}

/// The rotation of a hanging limb: about its length, then outward, then forward.
Quaterniond ball_joint(double flexion, double abduction, double rotation, double side) {
  return turn_about(Vec3::UnitX(), -flexion) * turn_about(Vec3::UnitZ(), side * abduction) *
         turn_about(Vec3::UnitY(), side * rotation);
}

/// The turn of a limb along `along` by which its lower part goes toward `toward`.
Quaterniond bend(const Vec3& along, const Vec3& toward, double degrees) {
  return turn_about(along.cross(toward).normalized(), degrees);
}

UpperBone upper_bone(const Vec3& joint, const Vec3& end, const Quaterniond& turn) {
  UpperBone bone;
  bone.joint = joint;
  bone.length = (end - joint).norm();
  bone.along = (end - joint) / bone.length;
  bone.swing = Quaterniond::FromTwoVectors(bone.along, turn * bone.along);
  const Quaterniond about_bone = bone.swing.conjugate() * turn;
  bone.twist = 2 * std::atan2(about_bone.vec().dot(bone.along), about_bone.w());
  bone.twist = std::remainder(bone.twist, 2 * std::numbers::pi);
  return bone;
}

/// The mean direction of the bones before and after a joint.
Vec3 mean_direction(const Vec3& before, const Vec3& joint, const Vec3& after) {
  return ((joint - before).normalized() + (after - joint).normalized()).normalized();
}

}  // namespace

RigidMotion UpperBone::at(const Vec3& p) const {
  const double share = along.dot(p - joint) / length;
  const double t = std::clamp((share - twist_from) / (twist_to - twist_from), 0.0, 1.0);
  const double part = t * t * (3 - 2 * t);
  return RigidMotion::about(joint, swing * Quaterniond(AngleAxisd(part * twist, along)));
}

RigidMotion UpperBone::end() const { return at(joint + length * along); }

SideMotion side_motion(const Skeleton& skeleton, const FootShape& foot, const SidePose& pose,
                       bool left) {
  const double side = left ? 1 : -1;
  const auto joint = [&](const std::string& name) {
    return skeleton.joint((left ? "left_" : "right_") + name);
  };
  const Vec3 shoulder = joint("shoulder");
  const Vec3 elbow = joint("elbow");
  const Vec3 hip = joint("hip");
  const Vec3 knee = joint("knee");
  const Vec3 ankle = joint("ankle");

  const Vec3 arm = (elbow - shoulder).normalized();
  const double abduction = std::asin(std::clamp(side * arm.x(), -1.0, 1.0)) / radians_per_degree;
  const double flexion =
      std::abs(arm.x()) > arm_sideways ? 0 : std::atan2(arm.z(), -arm.y()) / radians_per_degree;
  SideMotion motion;
  motion.upper_arm = upper_bone(
      shoulder, elbow,
      ball_joint(pose.shoulder_flexion, pose.shoulder_abduction, pose.shoulder_rotation, side) *
          ball_joint(flexion, abduction, 0, side).conjugate());
  motion.forearm = motion.upper_arm.end() *
                   RigidMotion::about(elbow, bend(mean_direction(shoulder, elbow, joint("wrist")),
                                                  Vec3::UnitZ(), pose.elbow_flexion));
  motion.thigh = upper_bone(
      hip, knee, ball_joint(pose.hip_flexion, pose.hip_abduction, pose.hip_rotation, side));
  motion.shin =
      motion.thigh.end() * RigidMotion::about(knee, bend(mean_direction(hip, knee, ankle),
                                                         -Vec3::UnitZ(), pose.knee_flexion));
  motion.foot =
      motion.shin * RigidMotion::about(ankle, bend(foot.along, -Vec3::UnitY(), pose.ankle_flexion));
  motion.toes = motion.foot *
                RigidMotion::about(foot.ball, bend(foot.along, Vec3::UnitY(), pose.toes_extension));
  return motion;
}

Skeleton moved(Skeleton skeleton, const std::array<SideMotion, 2>& sides) {
  for (const bool left : {true, false}) {
    const SideMotion& side = sides[left ? 0 : 1];
    const auto move = [&](const std::string& name, const RigidMotion& motion) {
      Vec3& joint = skeleton.joints.at((left ? "left_" : "right_") + name);
      joint = motion(joint);
    };
    move("elbow", side.upper_arm.end());
    move("wrist", side.forearm);
    move("knee", side.thigh.end());
    move("ankle", side.shin);
  }
  return skeleton;
}

}  // namespace toile
