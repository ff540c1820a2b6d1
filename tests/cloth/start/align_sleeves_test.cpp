#include "cloth/start/align_sleeves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cloth/figure.h"

namespace toile {
namespace align_sleeves_test {

using test::figure;
using test::pi;

constexpr int cells = 4;
constexpr int points = (cells + 1) * (cells + 1);

/// A sleeve of two panels, 20 cm in front of and 10 cm behind the left arm of figure(), which is
/// level. It runs down from a torso panel's edge at x = 0.2, by `steep` radians.
PanelMesh shirt(double steep) {
  PanelMesh garment;
  test::add_panel(garment, "body", test::grid(0.2, 0.2, cells, cells), [](const Vec2& p) {
    return Vec3(p.x(), 1.2 + p.y(), 0.25);
  }).is = classify({"", BodyPart::torso});
  for (const double z : {0.2, -0.1}) {
    test::add_panel(garment, z > 0 ? "front" : "back", test::grid(0.3, 0.2, cells, cells),
                    [&](const Vec2& p) {
                      const double across = p.y() - 0.1;
                      return Vec3(0.2 + std::cos(steep) * p.x() + std::sin(steep) * across,
                                  1.3 - std::sin(steep) * p.x() + std::cos(steep) * across, z);
                    })
        .is = classify({"", BodyPart::left_arm});
  }
  std::vector<int> upper, lower, upper_behind, lower_behind;
  for (int i = 0; i <= cells; ++i) {
    lower.push_back(points + i);
    upper.push_back(points + cells * (cells + 1) + i);
    lower_behind.push_back(2 * points + i);
    upper_behind.push_back(2 * points + cells * (cells + 1) + i);
  }
  garment.seams = {test::seam("upper", upper, upper_behind),
                   test::seam("lower", lower, lower_behind),
                   test::seam("armhole", test::side(garment.panels[1], cells, cells, false),
                              test::side(garment.panels[0], cells, cells, true))};
  return garment;
}

std::vector<BodyPart> parts() {
  std::vector<BodyPart> parts(3 * points, BodyPart::left_arm);
  std::fill_n(parts.begin(), points, BodyPart::torso);
  return parts;
}

TEST(TurnedSleeves, ASleeveIsTurnedToItsArm) {
  const PanelMesh garment = shirt(pi / 4);
  const PanelMesh level = shirt(0);
  std::vector<Vec3> placed = garment.placed;
  const auto turned = turn_sleeves(garment, parts(), figure(), placed);
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_NEAR(turned.at(BodyPart::left_arm), pi / 4, 1e-12);
  // About the middle of the armhole, so the sleeve now is as if drawn level; the body stays.
  for (std::size_t p = 0; p < placed.size(); ++p) {
    EXPECT_LT((placed[p] - level.placed[p]).norm(), 1e-12) << p;
  }
}

TEST(TurnedSleeves, FrontAndBackTurnEachAtItsOwnDepth) {
  Skeleton swung = figure();
  swung.joints["left_elbow"] = Vec3(0.15, 1.3, 0) + 0.3 * Vec3(std::cos(0.5), 0, std::sin(0.5));
  swung.joints["left_wrist"] = Vec3(0.15, 1.3, 0) + 0.6 * Vec3(std::cos(0.5), 0, std::sin(0.5));
  const PanelMesh garment = shirt(0);
  std::vector<Vec3> placed = garment.placed;
  EXPECT_NEAR(turn_sleeves(garment, parts(), swung, placed).at(BodyPart::left_arm), 0.5, 1e-12);
  for (int p = points; p < 2 * points; ++p) {
    EXPECT_LT((placed[p] - placed[p + points] - Vec3(0, 0, 0.3)).norm(), 1e-12) << p;
  }
  const Vec3 down = placed[points + cells] - placed[points];
  EXPECT_LT((down - 0.3 * Vec3(std::cos(0.5), 0, std::sin(0.5))).norm(), 1e-12);
}

TEST(TurnedSleeves, ASleeveThatRoughlyFollowsItsArmStays) {
  const PanelMesh garment = shirt(0.15);
  std::vector<Vec3> placed = garment.placed;
  EXPECT_TRUE(turn_sleeves(garment, parts(), figure(), placed).empty());
  EXPECT_EQ(placed, garment.placed);
}

TEST(TurnedSleeves, WhatTheSkeletonPositionedStays) {
  PanelMesh garment = shirt(pi / 4);
  for (MeshedPanel& panel : garment.panels) panel.placement.around = 0.5;
  std::vector<Vec3> placed = garment.placed;
  EXPECT_TRUE(turn_sleeves(garment, parts(), figure(), placed).empty());
}

}  // namespace align_sleeves_test
}  // namespace toile
