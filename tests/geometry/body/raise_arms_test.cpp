#include "geometry/body/raise_arms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/intersections.h"
#include "tests/support/standing_figure.h"

namespace toile {
namespace raise_arms_test {

constexpr double degree = std::numbers::pi / 180;

/// figure() with its arms `down` degrees below the horizontal.
Skeleton hanging(double down) {
  Skeleton skeleton = test::figure();
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "left" : "right";
    const Vec3 shoulder = skeleton.joint(name + "_shoulder");
    const Vec3 way(side * std::cos(down * degree), -std::sin(down * degree), 0);
    skeleton.joints[name + "_elbow"] = shoulder + 0.3 * way;
    skeleton.joints[name + "_wrist"] = shoulder + 0.55 * way;
  }
  return skeleton;
}

TEST(RaiseArms, ArmsComeToTheHorizontalAndTrunkAndHeadStay) {
  const Skeleton skeleton = hanging(45);
  const ArmRaise raise(skeleton, {});
  ASSERT_TRUE(raise.any());
  const Skeleton raised = raise.raised(skeleton);
  for (const std::string side : {"left", "right"}) {
    const Vec3 arm = raised.joint(side + "_wrist") - raised.joint(side + "_shoulder");
    EXPECT_NEAR(std::atan2(arm.y(), std::abs(arm.x())) / degree, 10, 1e-9);
    EXPECT_NEAR(arm.norm(), 0.55, 1e-12);
    EXPECT_LT(
        (raise.raised(skeleton.joint(side + "_elbow")) - raised.joint(side + "_elbow")).norm(),
        1e-12);
  }
  for (const char* joint : {"pelvis", "waist", "chest", "neck", "head", "left_knee"}) {
    EXPECT_LT((raise.raised(skeleton.joint(joint)) - skeleton.joint(joint)).norm(), 1e-12) << joint;
  }
  // Hips and flanks below the armpit stay, too.
  for (const Vec3& p : {Vec3(0.17, 1.0, 0.0), Vec3(-0.22, 0.8, 0.05), Vec3(0.15, 1.15, 0.02)}) {
    EXPECT_LT((raise.raised(p) - p).norm(), 1e-12) << p.transpose();
  }
}

TEST(RaiseArms, ArmsComeToTheAngleThatIsAskedFor) {
  const Skeleton skeleton = hanging(45);
  const Skeleton raised = ArmRaise(skeleton, {}, 50 * degree).raised(skeleton);
  const Vec3 arm = raised.joint("left_wrist") - raised.joint("left_shoulder");
  EXPECT_NEAR(std::atan2(arm.y(), arm.x()) / degree, 50, 1e-9);
}

class RaisedTo : public testing::TestWithParam<double> {};

TEST_P(RaisedTo, LoweringIsTheInverse) {
  const Mannequin mannequin = make_mannequin({.edge_length = 0.014});
  const ArmRaise raise(mannequin.skeleton, mannequin.surface, GetParam());
  ASSERT_TRUE(raise.any());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> across(-1, 1), up(0.2, 1.9), depth(-0.5, 0.5);
  double farthest = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(across(random), up(random), depth(random));
    EXPECT_LT((raise.lowered(raise.raised(p)) - p).norm(), 1e-9) << p.transpose();
    farthest = std::max(farthest, (raise.raised(p) - p).norm());
  }
  EXPECT_GT(farthest, 0.3);
}

INSTANTIATE_TEST_SUITE_P(RaiseArms, RaisedTo,
                         testing::Values(ArmRaise::usual_angle, ArmRaise::max_angle));

TEST(RaiseArms, BentArmsComeIntoThePlaneOfTheirShoulders) {
  Skeleton skeleton = hanging(45);
  for (const std::string side : {"left", "right"}) {
    skeleton.joints[side + "_elbow"] += Vec3(0, 0, 0.03);
    skeleton.joints[side + "_wrist"] += Vec3(0, 0, 0.17);
  }
  const ArmRaise raise(skeleton, {});
  const Vec3 shoulder = skeleton.joint("left_shoulder");
  EXPECT_NEAR(raise.raised(skeleton).joint("left_wrist").z(), shoulder.z(), 1e-12);
  // The bones, and the hand in their direction, too.
  const Vec3 elbow = skeleton.joint("left_elbow");
  const Vec3 wrist = skeleton.joint("left_wrist");
  for (const double t : {0.0, 0.5, 1.0, 1.4}) {
    EXPECT_NEAR(raise.raised(elbow + t * (wrist - elbow)).z(), shoulder.z(), 1e-3) << t;
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<double> across(-1, 1), up(0.2, 1.9), depth(-0.5, 0.5);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(across(random), up(random), depth(random));
    EXPECT_LT((raise.lowered(raise.raised(p)) - p).norm(), 1e-9) << p.transpose();
  }
  for (const char* joint : {"pelvis", "chest", "left_hip", "left_knee"}) {
    EXPECT_LT((raise.raised(skeleton.joint(joint)) - skeleton.joint(joint)).norm(), 1e-12) << joint;
  }
}

TEST(RaiseArms, TheRaisedBodyIsClearOfItselfAndSlim) {
  const Mannequin mannequin = make_mannequin({.edge_length = 0.014});
  const TriangleMesh& body = mannequin.surface;
  const Skeleton& skeleton = mannequin.skeleton;
  const ArmRaise raise(skeleton, body);
  const TriangleMesh raised = raise.raised(body);
  EXPECT_TRUE(self_intersections(raised).empty());
  const auto highest_hand = [](const TriangleMesh& mesh) {
    double height = 0;
    for (const Vec3& p : mesh.points) {
      if (std::abs(p.x()) > 0.5) height = std::max(height, p.y());
    }
    return height;
  };
  EXPECT_GT(highest_hand(raised), highest_hand(body) + 0.2);
  // At the middle of the lower arm, the skin is half as far from the bones as it was.
  const auto radius_at = [](const TriangleMesh& mesh, const Skeleton& bones) {
    const Vec3 from = bones.joint("left_shoulder");
    const Vec3 axis = (bones.joint("left_wrist") - from).normalized();
    const double middle = 0.8 * (bones.joint("left_wrist") - from).norm();
    double sum = 0;
    int count = 0;
    for (const Vec3& p : mesh.points) {
      const double along = axis.dot(p - from);
      const double radius = (p - from - along * axis).norm();
      if (std::abs(along - middle) > 0.03 || radius > 0.1) continue;
      sum += radius;
      ++count;
    }
    return sum / count;
  };
  EXPECT_NEAR(radius_at(raised, raise.raised(skeleton)) / radius_at(body, skeleton), 0.5, 0.1);
}

TEST(RaiseArms, ABodyWithLevelArmsStaysAsItIs) {
  EXPECT_FALSE(ArmRaise(test::figure(), {}).any());
  EXPECT_FALSE(ArmRaise({}, {}).any());
}

TEST(RaiseArms, OnlyPanelsOfArmsTurnWithThem) {
  const Skeleton skeleton = hanging(45);
  const ArmRaise raise(skeleton, {});
  const Vec3 elbow = skeleton.joint("left_elbow");
  EXPECT_EQ(raise.turned_with(BodyPart::torso, elbow), elbow);
  EXPECT_EQ(raise.turned_with(BodyPart::left_leg, elbow), elbow);
  // As one, however far before the arm.
  const Vec3 before = elbow + Vec3(0, 0, 0.4);
  EXPECT_LT((raise.turned_with(BodyPart::left_arm, before) -
             raise.turned_with(BodyPart::left_arm, elbow) - Vec3(0, 0, 0.4))
                .norm(),
            1e-12);
}

}  // namespace raise_arms_test
}  // namespace toile
