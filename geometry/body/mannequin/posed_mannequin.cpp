#include "geometry/body/mannequin/posed_mannequin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "geometry/body/mannequin/loft.h"

namespace toile {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

Vec3 mirrored(const Vec3& p) { return {-p.x(), p.y(), p.z()}; }

// Metres from a joint where the limb begins to bend: about the limb's thickness there.
constexpr double knee_reach = 0.070;
constexpr double elbow_reach = 0.055;
constexpr double toes_reach = 0.022;

/// Metres: a point of the line across the ball of the foot, on the sole.
const Vec3 ball_of_foot(0.094, 0, 0.092);
const Vec3 toe_tip(0.091, 0.01, 0.160);
const Vec3 heel(0.088, 0.01, -0.100);
const Vec3 finger_tip(0.673, 0.844, 0.010);

const Vec3& left(const std::string& joint) { return standing_joints().joint("left_" + joint); }

/// The rotation of a hanging limb, degrees: about its length, then outward, then forward.
Eigen::Matrix3d ball_joint(double flexion, double abduction, double rotation) {
  using Eigen::AngleAxisd;
  return (AngleAxisd(radians(-flexion), Vec3::UnitX()) *
          AngleAxisd(radians(abduction), Vec3::UnitZ()) *
          AngleAxisd(radians(rotation), Vec3::UnitY()))
      .toRotationMatrix();
}

}  // namespace

const Skeleton& standing_joints() {
  static const Skeleton skeleton = [] {
    Skeleton made;
    made.joints = {{"pelvis", {0, 0.763, -0.014}},
                   {"waist", {0, 1.069, 0.009}},
                   {"chest", {0, 1.264, 0.001}},
                   {"neck", {0, 1.443, -0.034}},
                   {"head", {0, 1.700, -0.004}}};
    const auto both = [&made](const std::string& joint, const Vec3& point) {
      made.joints["left_" + joint] = point;
      made.joints["right_" + joint] = mirrored(point);
    };
    both("hip", {0.093, 0.831, -0.014});
    both("knee", {0.090, 0.465, -0.005});
    both("ankle", {0.088, 0.072, -0.036});
    both("shoulder", {0.160, 1.357, -0.034});
    both("elbow", {0.365, 1.152, -0.034});
    both("wrist", {0.524, 0.993, -0.009});
    made.segments = body_segments();
    return made;
  }();
  return skeleton;
}

PosedSide::PosedSide(const SidePose& pose)
    : hip_{left("hip"), ball_joint(pose.hip_flexion, pose.hip_abduction, pose.hip_rotation)},
      knee_(left("knee"), -Vec3::UnitY(), -Vec3::UnitZ(), radians(pose.knee_flexion), knee_reach),
      ankle_{left("ankle"),
             Eigen::AngleAxisd(radians(pose.ankle_flexion), Vec3::UnitX()).toRotationMatrix()},
      toes_(ball_of_foot, Vec3::UnitZ(), Vec3::UnitY(), radians(pose.toes_extension), toes_reach),
      shoulder_{left("shoulder"),
                ball_joint(pose.shoulder_flexion, pose.shoulder_abduction, pose.shoulder_rotation) *
                    ball_joint(0, -45, 0)},
      elbow_(left("elbow"), Vec3(1, -1, 0).normalized(), Vec3::UnitZ(), radians(pose.elbow_flexion),
             elbow_reach) {}

PosedMannequin::PosedMannequin(const MannequinShape& shape, const Pose& pose)
    : shape_(shape), left_(pose.left), right_(pose.right) {}

double PosedMannequin::leg(const PosedSide& side, const Vec3& point) const {
  const Vec3 at_rest = side.leg_at_rest(point);
  return smooth_union(shape_.leg_distance(at_rest),
                      shape_.foot_distance(side.foot_at_rest(at_rest)), 0.04);
}

double PosedMannequin::arm(const PosedSide& side, const Vec3& point) const {
  return shape_.arm_distance(side.arm_at_rest(point));
}

double PosedMannequin::distance(const Vec3& p) const {
  const Vec3 q = mirrored(p);
  double body =
      smooth_union(shape_.trunk_distance(p), std::min(leg(left_, p), leg(right_, q)), 0.06);
  return smooth_union(body, std::min(arm(left_, p), arm(right_, q)), 0.045);
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
  Skeleton posed = standing_joints();
  for (const bool is_left : {true, false}) {
    const PosedSide& side = is_left ? left_ : right_;
    const auto move = [&](const std::string& joint, const Vec3& to) {
      posed.joints[(is_left ? "left_" : "right_") + joint] = is_left ? to : mirrored(to);
    };
    // At the joint the arc cuts the corner, but the skeleton's bones still meet in the joint.
    move("knee", side.hip().posed(left("knee")));
    move("ankle", side.leg(left("ankle")));
    move("elbow", side.shoulder().posed(left("elbow")));
    move("wrist", side.arm(left("wrist")));
  }
  return posed;
}

std::pair<Vec3, Vec3> PosedMannequin::box() const {
  Vec3 low(-0.20, 0.75, -0.12);
  Vec3 high(0.20, 1.71, 0.12);
  for (const PosedSide* side : {&left_, &right_}) {
    for (const Vec3& point :
         {side->leg(left("knee")), side->leg(left("ankle")), side->foot(toe_tip), side->foot(heel),
          side->arm(left("elbow")), side->arm(left("wrist")), side->arm(finger_tip)}) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  constexpr double margin = 0.10;
  const double aside = std::max(-low.x(), high.x()) + margin;
  return {Vec3(-aside, low.y() - margin, low.z() - margin),
          Vec3(aside, std::max(high.y() + margin, 1.72), high.z() + margin)};
}

}  // namespace toile
