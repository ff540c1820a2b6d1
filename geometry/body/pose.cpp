#include "geometry/body/pose.h"

#include <string>

#include "geometry/error.h"

namespace toile {

Pose standing_pose() { return {}; }

Pose walking_pose() {
  Pose pose;
  pose.left.hip_flexion = 22;
  pose.left.knee_flexion = 4;
  pose.left.ankle_flexion = 12;
  pose.right.hip_flexion = -13;
  pose.right.knee_flexion = 20;
  pose.right.ankle_flexion = -5;
  pose.right.toes_extension = 28;
  pose.left.shoulder_abduction = pose.right.shoulder_abduction = 30;
  pose.left.shoulder_flexion = -20;
  pose.left.elbow_flexion = 10;
  pose.right.shoulder_flexion = 20;
  pose.right.elbow_flexion = 15;
  return pose;
}

Pose sitting_pose() {
  Pose pose;
  for (SidePose* side : {&pose.left, &pose.right}) {
    side->hip_flexion = 90;
    side->knee_flexion = 90;
    side->shoulder_abduction = 30;
  }
  return pose;
}

Pose reaching_pose() {
  Pose pose;
  pose.left.shoulder_abduction = 30;
  pose.right.shoulder_flexion = 150;
  pose.right.shoulder_abduction = 15;
  return pose;
}

Pose mirrored(const Pose& pose) { return {pose.right, pose.left}; }

void check_pose(const Pose& pose, const std::string& name, PosedFigure figure) {
  for (const bool left : {true, false}) {
    const SidePose& side = left ? pose.left : pose.right;
    for (const JointMotion& motion : joint_motions) {
      const double angle = side.*motion.angle;
      const bool of_body = figure == PosedFigure::body;
      const double min = of_body ? motion.body_min : motion.min;
      const double max = of_body ? motion.body_max : motion.max;
      if (angle >= min && angle <= max) continue;
      throw Error(name + ": " + (left ? "left_" : "right_") + std::string(motion.joint),
                  number_text(angle) + " degrees of " + std::string(motion.motion) +
                      " are beyond what the joint does",
                  "give " + number_text(min) + " to " + number_text(max));
    }
  }
}

}  // namespace toile
