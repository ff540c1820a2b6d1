#include "geometry/body/bone_motion.h"

#include <gtest/gtest.h>

#include "tests/support/standing_figure.h"

namespace toile {
namespace bone_motion_test {

TEST(BoneMotion, ABentElbowPointsForwardWithTheThumb) {
  SidePose pose;
  pose.shoulder_abduction = 0;
  pose.elbow_flexion = 90;
  const Skeleton figure = test::figure();
  const SideMotion left = side_motion(figure, {}, pose, true);
  const SideMotion right = side_motion(figure, {}, pose, false);
  const Skeleton posed = moved(figure, {left, right});
  for (const std::string side : {"left_", "right_"}) {
    const Vec3 arm = (posed.joint(side + "elbow") - posed.joint(side + "shoulder")).normalized();
    EXPECT_LT((arm + Vec3::UnitY()).norm(), 1e-9) << side;
    const Vec3 forearm = (posed.joint(side + "wrist") - posed.joint(side + "elbow")).normalized();
    EXPECT_GT(forearm.z(), 0.99) << side;
  }
}

TEST(BoneMotion, TurnsOutTheFootWithoutMovingTheThighsTop) {
  SidePose pose;
  pose.hip_rotation = 40;
  const Skeleton figure = test::figure();
  for (const bool left : {true, false}) {
    const SideMotion motion = side_motion(figure, {}, pose, left);
    const Vec3 hip = figure.joint(left ? "left_hip" : "right_hip");
    const Vec3 top = hip + Vec3(0.05, 0, 0.05);
    EXPECT_LT((motion.thigh.at(top)(top) - top).norm(), 1e-12);
    // The toes come out to the foot's own side.
    const Vec3 ankle = figure.joint(left ? "left_ankle" : "right_ankle");
    const Vec3 toes = motion.toes(ankle + Vec3(0, 0, 0.15)) - motion.toes(ankle);
    EXPECT_NEAR((left ? 1 : -1) * toes.x(), 0.15 * std::sin(40 * 3.14159265 / 180), 1e-3);
  }
}

TEST(BoneMotion, OfTheStandingPoseLeavesLegsAsTheyStand) {
  const SideMotion motion = side_motion(test::figure(), {}, standing_pose().left, true);
  const Vec3 p(0.1, 0.3, 0.05);
  EXPECT_LT((motion.shin(p) - p).norm(), 1e-12);
  EXPECT_LT((motion.toes(p) - p).norm(), 1e-12);
}

}  // namespace bone_motion_test
}  // namespace toile
