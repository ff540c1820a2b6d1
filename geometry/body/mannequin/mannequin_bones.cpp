#include "geometry/body/mannequin/mannequin_bones.h"

namespace toile {

namespace {

Skeleton sample_joints() {
  Skeleton made;
  made.joints = {{"pelvis", {0, 0.763, -0.014}},
                 {"waist", {0, 1.069, 0.009}},
                 {"chest", {0, 1.264, 0.001}},
                 {"neck", {0, 1.443, -0.034}},
                 {"head", {0, 1.700, -0.004}}};
  const auto both = [&made](const std::string& joint, const Vec3& point) {
    made.joints["left_" + joint] = point;
    made.joints["right_" + joint] = Vec3(-point.x(), point.y(), point.z());
  };
  both("hip", {0.093, 0.831, -0.014});
  both("knee", {0.090, 0.465, -0.005});
  both("ankle", {0.088, 0.072, -0.036});
  both("shoulder", {0.160, 1.357, -0.034});
  both("elbow", {0.365, 1.152, -0.034});
  both("wrist", {0.524, 0.993, -0.009});
  made.segments = body_segments();
  return made;
}

}  // namespace

const MannequinBones& sample_bones() {
  static const MannequinBones bones = {.joints = sample_joints(),
                                       .ball_of_foot = {0.094, 0, 0.092},
                                       .toe_tip = {0.091, 0.01, 0.160},
                                       .heel = {0.088, 0.01, -0.100},
                                       .finger_tip = {0.673, 0.844, 0.010},
                                       .knee_reach = 0.070,
                                       .elbow_reach = 0.055,
                                       .toes_reach = 0.022,
                                       .low = {-0.75, -0.01, -0.25},
                                       .high = {0.75, 1.72, 0.25},
                                       .trunk_low = {-0.20, 0.75, -0.12},
                                       .trunk_high = {0.20, 1.71, 0.12}};
  return bones;
}

}  // namespace toile
