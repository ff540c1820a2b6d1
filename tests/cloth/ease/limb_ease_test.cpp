#include "cloth/ease/limb_ease.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/standing_figure.h"
#include "tests/support/tubes.h"

namespace toile {
namespace limb_ease_test {

constexpr double pi = std::numbers::pi;

/// Points of a tube around the y axis, turned onto an arm that points to the left.
void lay_on_left_arm(std::vector<Vec3>& points) {
  for (Vec3& p : points) p = Vec3(p.y(), 1.3 - p.x(), p.z());
}

/// An arm of radius 4 cm, up to the wrist.
TriangleMesh left_arm() {
  TriangleMesh arm = test::closed_tube(0.04, 0.04, 0.8, 200);
  lay_on_left_arm(arm.points);
  return arm;
}

DressedGarment left_sleeve(double radius, double from, double to) {
  DressedGarment sleeve = test::cloth_tube(radius, radius, from, to, 40, 20);
  lay_on_left_arm(sleeve.points);
  return sleeve;
}

TEST(LimbEase, ACuffOnTheForearmIsMeasuredOnTheFlat) {
  // Two panels of 20 cells of 1 cm, stretched around a radius of 7 cm.
  const auto limbs = measure_limb_ease(left_sleeve(0.07, 0.52, 0.58), left_arm(), test::figure());
  ASSERT_EQ(limbs.size(), 1U);
  EXPECT_EQ(limbs[0].limb, "left forearm");
  EXPECT_NEAR(limbs[0].body, 2 * pi * 0.04, 1e-4);
  EXPECT_NEAR(limbs[0].garment, 2 * pi * 0.07, 1e-3);
  EXPECT_NEAR(limbs[0].as_cut, 0.4, 1e-9);
  EXPECT_NEAR(limbs[0].at.x(), 0.45 + limbs[0].share * 0.25, 1e-9);
}

TEST(LimbEase, TheNarrowestPlaceCounts) {
  DressedGarment sleeve = left_sleeve(0.07, 0.25, 0.65);
  // Row 15 of 20 is cut to half of its width.
  for (Vec2& p : sleeve.flat) {
    if (std::abs(p.y() - 0.15) < 1e-9) p.x() *= 0.5;
  }
  const auto limbs = measure_limb_ease(sleeve, left_arm(), test::figure());
  ASSERT_EQ(limbs.size(), 2U);
  EXPECT_EQ(limbs[0].limb, "left upper arm");
  EXPECT_NEAR(limbs[0].as_cut, 0.4, 1e-9);
  EXPECT_EQ(limbs[1].limb, "left forearm");
  // Row 15 is worn 0.55 m from the middle, where a plane lies 1 cm at most away.
  EXPECT_NEAR(limbs[1].at.x(), 0.55, 0.006);
  EXPECT_LT(limbs[1].as_cut, 0.27);
}

TEST(LimbEase, ClothBesideTheArmOrOpenHasNone) {
  DressedGarment sleeve = left_sleeve(0.07, 0.5, 0.6);
  for (Vec3& p : sleeve.points) p.y() += 0.5;
  EXPECT_TRUE(measure_limb_ease(sleeve, left_arm(), test::figure()).empty());
  DressedGarment half = left_sleeve(0.07, 0.5, 0.6);
  std::erase_if(half.triangles, [](const Triangle& t) { return t[0] % 40 < 20; });
  half.flat_triangles.resize(half.triangles.size());
  half.panel_of_triangle.resize(half.triangles.size());
  EXPECT_TRUE(measure_limb_ease(half, left_arm(), test::figure()).empty());
}

TEST(LimbEase, AJointThatIsMissingLeavesItsLimbOut) {
  Skeleton without = test::figure();
  without.joints.erase("left_wrist");
  EXPECT_TRUE(measure_limb_ease(left_sleeve(0.07, 0.5, 0.6), left_arm(), without).empty());
}

}  // namespace limb_ease_test
}  // namespace toile
