#include "cloth/judge/wraps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth/start/panel_parts.h"
#include "tests/cloth/figure.h"

namespace toile {
namespace wraps_test {

using test::add_half;
using test::figure;
using test::tube;
using test::tube_columns;
using test::tube_radius;

constexpr double pi = std::numbers::pi;

std::vector<Vec3> moved(std::vector<Vec3> points, const Vec3& displacement) {
  for (Vec3& p : points) p += displacement;
  return points;
}

double torso(const PanelMesh& garment, const std::vector<Vec3>& points) {
  const auto wraps = measure_wraps(garment, test::as_dressed(garment, points), figure());
  EXPECT_EQ(wraps.size(), 1U);
  EXPECT_EQ(wraps[0].part, BodyPart::torso);
  return wraps[0].fraction;
}

TEST(Wraps, ATubeAroundTheBones) {
  const PanelMesh garment = tube();
  const auto wraps = measure_wraps(garment, test::as_dressed(garment, garment.placed), figure());
  ASSERT_EQ(wraps.size(), 1U);
  EXPECT_NEAR(wraps[0].fraction, 1, 1e-3);
  // From the pelvis at 0 to 60 cm up the bones, of which the armpits leave 40.
  EXPECT_NEAR(wraps[0].from, 0.25 * 0.4, 0.01);
  EXPECT_NEAR(wraps[0].to, 0.75 * 0.4, 0.01);
}

TEST(Wraps, ATubeIsMeasuredWhereItLies) {
  PanelMesh garment = tube();
  garment.placed = moved(garment.placed, {0, -0.3, 0});
  for (const double displacement : {-0.4, -0.25, -0.1, 0.0, 0.1}) {
    const auto points = moved(garment.placed, {0, displacement, 0});
    const WrapMeasurement wrap =
        measure_wraps(garment, test::as_dressed(garment, points), figure()).at(0);
    EXPECT_NEAR(wrap.fraction, 1, 1e-3);
    EXPECT_NEAR(wrap.from, -0.3 + displacement + 0.25 * 0.6, 0.02);
    EXPECT_NEAR(wrap.to, -0.3 + displacement + 0.75 * 0.6, 0.02);
  }
}

TEST(Wraps, AHemBunchedUpIsNotHeldAgainstIt) {
  PanelMesh garment = tube();
  // 60 cm of cloth squeezed to 15 cm above the hips.
  std::vector<Vec3> points = garment.placed;
  for (Vec3& p : points) p.y() = 1.0 + 0.25 * (p.y() - 0.8);
  EXPECT_NEAR(torso(garment, points), 1, 1e-3);
}

TEST(Wraps, HalfATube) {
  PanelMesh garment;
  add_half(garment, "front", -pi / 2);
  EXPECT_NEAR(torso(garment, garment.placed), 0.5, 0.01);
}

TEST(Wraps, ATubeThatSlippedOff) {
  const PanelMesh garment = tube();
  // Beside the body, and above its armpits.
  EXPECT_LT(torso(garment, moved(garment.placed, {0.5, 0, 0})), 0.2);
  EXPECT_EQ(torso(garment, moved(garment.placed, {0, 0.5, 0})), 0);
}

TEST(Wraps, ATubeWithASlit) {
  // The front, spread around nine tenths of the displacement.
  PanelMesh garment;
  add_half(garment, "front", -pi / 2);
  std::vector<Vec3> points = garment.placed;
  for (Vec3& p : points) {
    const double angle = 1.8 * std::atan2(p.x(), p.z());
    p.x() = tube_radius * std::sin(angle);
    p.z() = tube_radius * std::cos(angle);
  }
  EXPECT_NEAR(torso(garment, points), 0.9, 0.01);
}

/// Adds a tube around the left arm, drafted from x = 0.2 to 0.6.
void add_sleeve(PanelMesh& garment) {
  MeshedPanel& panel =
      test::add_panel(garment, "sleeve", test::grid(0.4, 2 * pi * 0.08, 20, 20), [](const Vec2& p) {
        const double angle = p.y() / 0.08;
        return Vec3(0.2 + p.x(), 1.3 + 0.08 * std::cos(angle), 0.08 * std::sin(angle));
      });
  panel.is = classify({"", BodyPart::left_arm});
  std::vector<int> low, high;
  for (int i = 0; i <= 20; ++i) {
    low.push_back(panel.first_point + i);
    high.push_back(panel.first_point + 20 * 21 + i);
  }
  garment.seams.push_back(test::seam("underarm", low, high));
  // Caught to the front in one point, as every sleeve is sewn to a bodice.
  garment.seams.push_back(
      test::seam("armhole", {garment.panels[0].first_point + tube_columns}, {panel.first_point}));
}

TEST(Wraps, ASleeveIsMeasuredAroundItsArm) {
  PanelMesh garment = tube();
  add_sleeve(garment);
  const MeshedPanel sleeve = garment.panels.back();
  const auto share_at = [&](const Vec3& displacement) {
    std::vector<Vec3> points = garment.placed;
    for (int p = sleeve.first_point; p < sleeve.first_point + sleeve.points; ++p)
      points[p] += displacement;
    const auto wraps = measure_wraps(garment, test::as_dressed(garment, points), figure());
    EXPECT_EQ(wraps.size(), 2U);
    EXPECT_NEAR(wraps[0].fraction, 1, 1e-3);
    EXPECT_EQ(wraps[1].part, BodyPart::left_arm);
    return wraps[1].fraction;
  };
  EXPECT_NEAR(share_at({0, 0, 0}), 1, 1e-3);
  // Slipped along the arm it still goes around it; off the arm it does not.
  EXPECT_GT(share_at({0.2, 0, 0}), 0.99);
  EXPECT_LT(share_at({0, -0.5, 0}), 0.15);
}

TEST(Wraps, PanelsBelongToWhatTheyArePlacedAt) {
  PanelMesh garment;
  const auto add = [&](const std::string& name, const Vec3& middle, double width) {
    test::add_panel(garment, name, test::grid(width, 0.2, 4, 4), [&](const Vec2& p) {
      return Vec3(middle + Vec3(p.x() - width / 2, p.y() - 0.1, 0));
    });
  };
  add("front", {0, 1.1, 0.2}, 0.4);
  add("left sleeve", {0.45, 1.3, 0.1}, 0.3);
  add("right sleeve", {-0.45, 1.3, -0.1}, 0.3);
  add("left trouser", {0.12, 0.4, 0.1}, 0.2);
  add("skirt", {0, 0.4, 0.2}, 0.5);
  add("told", {0, 1.1, 0.2}, 0.4);
  garment.panels.back().is = classify({"", BodyPart::head});
  EXPECT_EQ(panel_parts(garment, figure()),
            (std::vector{BodyPart::torso, BodyPart::left_arm, BodyPart::right_arm,
                         BodyPart::left_leg, BodyPart::torso, BodyPart::head}));
}

TEST(Wraps, HalfAFrontIsTheTorsosThoughAnArmHangsBehindIt) {
  Skeleton skeleton = figure();
  skeleton.joints["left_elbow"] = {0.2, 1.0, 0.1};
  skeleton.joints["left_wrist"] = {0.2, 0.8, 0.2};
  PanelMesh garment;
  const auto add = [&](const std::string& name, double inner_edge) {
    test::add_panel(garment, name, test::grid(0.28, 0.4, 4, 4),
                    [&](const Vec2& p) { return Vec3(inner_edge + p.x(), 0.95 + p.y(), 0.25); });
  };
  add("front", 0);
  add("sleeve", 0.08);
  EXPECT_EQ(panel_parts(garment, skeleton), (std::vector{BodyPart::torso, BodyPart::left_arm}));
}

TEST(Wraps, TheBarestLevelIsWhereAPanelEnds) {
  PanelMesh garment = tube();
  const DressedGarment whole = test::as_dressed(garment, garment.placed);
  EXPECT_NEAR(barest_level(whole, figure(), {1, 1}, 1.0, 1.2).share, 1, 0.01);
  // The front ends at 1.1 m.
  for (Vec3& p : garment.placed) {
    if (p.z() > 0) p.y() = 0.8 + (p.y() - 0.8) / 2;
  }
  const DressedGarment low = test::as_dressed(garment, garment.placed);
  const BareLevel barest = barest_level(low, figure(), {1, 1}, 0.9, 1.3);
  EXPECT_LT(barest.share, 0.6);
  EXPECT_GT(barest.height, 1.1);
  // There is no level between heights that are exchanged.
  EXPECT_EQ(barest_level(whole, figure(), {1, 1}, 1.2, 1.0).share, 1);
}

}  // namespace wraps_test
}  // namespace toile
