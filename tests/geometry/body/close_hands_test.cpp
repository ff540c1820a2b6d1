#include "geometry/body/close_hands.h"

#include <gtest/gtest.h>

#include "geometry/surface_distance.h"
#include "tests/support/shapes.h"

namespace toile {
namespace close_hands_test {

/// An arm along x up to the wrist at 0.5 m and a palm, as one box.
TriangleMesh arm() { return test::box({0, -0.03, -0.03}, {0.6, 0.03, 0.03}); }

/// An arm with three fingers, 2 cm apart, a millimetre off the palm.
TriangleMesh arm_with_fingers() {
  TriangleMesh mesh = arm();
  for (const double y : {-0.05, -0.01, 0.03}) {
    append(mesh, test::box({0.601, y, -0.01}, {0.7, y + 0.02, 0.01}));
  }
  return mesh;
}

Skeleton bones() {
  Skeleton skeleton;
  skeleton.joints = {{"left_elbow", Vec3(0.25, 0, 0)}, {"left_wrist", Vec3(0.5, 0, 0)}};
  return skeleton;
}

TEST(CloseHands, GapsBetweenFingersAreFilledAndTheArmStays) {
  const TriangleMesh body = arm_with_fingers();
  const TriangleMesh closed = with_hands_closed(body, bones());
  const SurfaceDistance before(body);
  const SurfaceDistance after(closed);
  for (const Vec3& gap : {Vec3(0.65, -0.02, 0), Vec3(0.69, 0.02, 0.005)}) {
    EXPECT_GT(before.closest_point(gap).distance, 0.005) << gap.transpose();
    EXPECT_LT(after.closest_point(gap).distance, -0.001) << gap.transpose();
  }
  // No point of the body lies outside, and far from the hand nothing is added.
  for (const Vec3& p : body.points) EXPECT_LT(after.closest_point(p).distance, 1e-9);
  EXPECT_NEAR(after.closest_point(Vec3(0.3, 0.05, 0)).distance, 0.02, 1e-9);
  EXPECT_GT(after.closest_point(Vec3(0.71, 0, 0)).distance, 0.009);
}

TEST(CloseHands, AMittenAndAnArmWithoutWristStayAsTheyAre) {
  EXPECT_EQ(with_hands_closed(arm(), bones()).points, arm().points);
  EXPECT_EQ(with_hands_closed(arm_with_fingers(), {}).points, arm_with_fingers().points);
}

TEST(CloseHands, AHandThatCrossesItselfStaysAsItIs) {
  TriangleMesh body = arm_with_fingers();
  append(body, test::box({0.65, -0.055, -0.015}, {0.68, 0.055, 0.005}));
  EXPECT_EQ(with_hands_closed(body, bones()).triangles, body.triangles);
}

}  // namespace close_hands_test
}  // namespace toile
