#include "geometry/body/mannequin/posed_mannequin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "geometry/body/mannequin/loft.h"

namespace toile {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

const Vec3& left(const MannequinBones& bones, const std::string& joint) {
  return bones.joints.joint("left_" + joint);
}

/// The rotation of a hanging limb, degrees: about its length, then outward, then forward.
Eigen::Matrix3d ball_joint(double flexion, double abduction, double rotation) {
  using Eigen::AngleAxisd;
  return (AngleAxisd(radians(-flexion), Vec3::UnitX()) *
          AngleAxisd(radians(abduction), Vec3::UnitZ()) *
          AngleAxisd(radians(rotation), Vec3::UnitY()))
      .toRotationMatrix();
}

}  // namespace

PosedSide::PosedSide(const SidePose& pose, const MannequinBones& bones)
    : hip_{left(bones, "hip"), ball_joint(pose.hip_flexion, pose.hip_abduction, pose.hip_rotation)},
      knee_(left(bones, "knee"), -Vec3::UnitY(), -Vec3::UnitZ(), radians(pose.knee_flexion),
            bones.knee_reach),
      ankle_{left(bones, "ankle"),
             Eigen::AngleAxisd(radians(pose.ankle_flexion), Vec3::UnitX()).toRotationMatrix()},
      toes_(bones.ball_of_foot, Vec3::UnitZ(), Vec3::UnitY(), radians(pose.toes_extension),
            bones.toes_reach),
      shoulder_{left(bones, "shoulder"),
                ball_joint(pose.shoulder_flexion, pose.shoulder_abduction, pose.shoulder_rotation) *
                    ball_joint(0, -45, 0)},
      elbow_(left(bones, "elbow"), Vec3(1, -1, 0).normalized(), Vec3::UnitZ(),
             radians(pose.elbow_flexion), bones.elbow_reach) {}

PosedMannequin::PosedMannequin(const MannequinShape& shape, const Pose& pose)
    : shape_(shape), left_(pose.left, shape.bones()), right_(pose.right, shape.bones()) {}

double PosedMannequin::leg(const PosedSide& side, const Vec3& point) const {
  const Vec3 at_rest = side.leg_at_rest(point);
  return smooth_union(shape_.leg_distance(at_rest),
                      shape_.foot_distance(side.foot_at_rest(at_rest)),
                      0.04 * shape_.solids().size);
}

double PosedMannequin::arm(const PosedSide& side, const Vec3& point) const {
  return shape_.arm_distance(side.arm_at_rest(point));
}

double PosedMannequin::distance(const Vec3& p) const {
  const Vec3 q = mirrored(p);
  double body = smooth_union(shape_.trunk_distance(p), std::min(leg(left_, p), leg(right_, q)),
                             0.06 * shape_.solids().size);
  return smooth_union(body, std::min(arm(left_, p), arm(right_, q)), 0.045 * shape_.solids().size);
}

Vec3 PosedMannequin::centre(const GirthTarget& target) const {
  const Vec3 rest = shape_.centre(target);
  if (target.part == MannequinPart::leg) return left_.leg(rest);
  if (target.part == MannequinPart::arm) return left_.arm(rest);
  return rest;
}

Vec3 PosedMannequin::normal(const GirthTarget& target) const {
  const Vec3 centre = shape_.centre(target);
  const Vec3 rest = shape_.normal(target);
  if (target.part == MannequinPart::leg) return left_.leg_turn(centre) * rest;
  if (target.part == MannequinPart::arm) return left_.arm_turn(centre) * rest;
  return rest;
}

Skeleton PosedMannequin::skeleton() const {
  const MannequinBones& bones = shape_.bones();
  Skeleton posed = bones.joints;
  for (const bool is_left : {true, false}) {
    const PosedSide& side = is_left ? left_ : right_;
    const auto move = [&](const std::string& joint, const Vec3& to) {
      posed.joints[(is_left ? "left_" : "right_") + joint] = is_left ? to : mirrored(to);
    };
    // At the joint the arc cuts the corner, but the skeleton's bones still meet in the joint.
    move("knee", side.hip().posed(left(bones, "knee")));
    move("ankle", side.leg(left(bones, "ankle")));
    move("elbow", side.shoulder().posed(left(bones, "elbow")));
    move("wrist", side.arm(left(bones, "wrist")));
  }
  return posed;
}

std::pair<Vec3, Vec3> PosedMannequin::box() const {
  const MannequinBones& bones = shape_.bones();
  Vec3 low = bones.trunk_low;
  Vec3 high = bones.trunk_high;
  for (const PosedSide* side : {&left_, &right_}) {
    for (const Vec3& point :
         {side->leg(left(bones, "knee")), side->leg(left(bones, "ankle")),
          side->foot(bones.toe_tip), side->foot(bones.heel), side->arm(left(bones, "elbow")),
          side->arm(left(bones, "wrist")), side->arm(bones.finger_tip)}) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  constexpr double margin = 0.10;
  const double aside = std::max(-low.x(), high.x()) + margin;
  return {Vec3(-aside, low.y() - margin, low.z() - margin),
          Vec3(aside, std::max(high.y() + margin, bones.trunk_high.y() + 0.01), high.z() + margin)};
}

}  // namespace toile
