#include "cloth/start/around_panels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/cloth/panels.h"

namespace toile {
namespace around_panels_test {

using test::add_panel;
using test::grid;

const auto at_origin = [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); };

/// A sleeve of one piece, 0.4 x 0.5 m, whose left and right edges are sewn together.
PanelMesh sleeve() {
  PanelMesh garment;
  add_panel(garment, "sleeve", grid(0.4, 0.5, 4, 5), at_origin);
  garment.seams = {test::seam("underarm", test::side(garment.panels[0], 4, 5, false),
                              test::side(garment.panels[0], 4, 5, true))};
  return garment;
}

TEST(AroundPanels, TheSeamsToOthersAreUp) {
  PanelMesh garment = sleeve();
  EXPECT_EQ(up_axis(garment, 0, true), PlacementAxis::plus_y);
  add_panel(garment, "front", grid(0.4, 0.5, 4, 5), at_origin);
  // The sleeve's lower edge is sewn to the front.
  garment.seams.push_back(test::seam("armhole", {0, 1, 2, 3, 4}, {30, 31, 32, 33, 34}));
  EXPECT_EQ(up_axis(garment, 0, true), PlacementAxis::minus_y);
  EXPECT_EQ(up_axis(garment, 0, false), PlacementAxis::plus_y);
}

TEST(AroundPanels, ASleeveDrawnLevelRunsAlongX) {
  PanelMesh garment;
  add_panel(garment, "sleeve", grid(0.5, 0.4, 5, 4), at_origin);
  std::vector<int> lower, upper;
  for (int i = 0; i <= 5; ++i) {
    lower.push_back(i);
    upper.push_back(24 + i);
  }
  garment.seams = {test::seam("underarm", lower, upper)};
  EXPECT_EQ(up_axis(garment, 0, true), PlacementAxis::plus_x);
}

TEST(AroundPanels, AnOpenCuffDrawnUprightRunsAlongX) {
  PanelMesh garment;
  add_panel(garment, "cuff", grid(0.1, 0.4, 1, 4), at_origin);
  add_panel(garment, "sleeve", grid(0.4, 0.5, 4, 5), at_origin);
  // The cuff's right side is sewn to the sleeve's lower edge.
  garment.seams = {test::seam("cuff", {1, 3, 5, 7, 9}, {10, 11, 12, 13, 14})};
  EXPECT_EQ(up_axis(garment, 0, true), PlacementAxis::plus_x);
}

/// A strip of 0.8 x 0.1 m whose lower edge is sewn to the upper one of another.
PanelMesh strips() {
  PanelMesh garment;
  add_panel(garment, "strip", grid(0.8, 0.1, 8, 1), at_origin);
  add_panel(garment, "rest", grid(0.8, 0.1, 8, 1), at_origin);
  garment.seams = {
      test::seam("long", {0, 1, 2, 3, 4, 5, 6, 7, 8}, {27, 28, 29, 30, 31, 32, 33, 34, 35})};
  return garment;
}

TEST(AroundPanels, WhatIsSewnAcrossIsNoStrip) {
  PanelMesh garment = strips();
  EXPECT_TRUE(may_be_strip(garment, 0));
  add_panel(garment, "other half", grid(0.8, 0.1, 8, 1), at_origin);
  garment.seams.push_back(test::seam("end", {8, 17}, {36, 45}));
  EXPECT_FALSE(may_be_strip(garment, 0));
  // The other half is sewn to nothing else.
  EXPECT_TRUE(may_be_strip(garment, 2));
}

// Half a circle skirt: its sides, too, run along the length of the panel.
TEST(AroundPanels, WhereSewnSidesTurnACornerIsNoStrip) {
  PanelMesh garment;
  for (int half = 0; half < 2; ++half) {
    add_panel(garment, half == 0 ? "front" : "back", grid(1, 0.5, 8, 2), at_origin);
    for (int p = 27 * half; p < 27 * (half + 1); ++p) {
      // From the waist, at y = 0.5, down to the hem; the sides run level.
      const double angle = std::numbers::pi * (garment.flat[p].x() - 1);
      const double radius = 0.65 - garment.flat[p].y();
      garment.flat[p] = {radius * std::cos(angle), radius * std::sin(angle)};
    }
  }
  add_panel(garment, "waistband", grid(0.9, 0.05, 8, 1), at_origin);
  garment.seams = {test::seam("waist", {18, 19, 20, 21, 22, 23, 24, 25, 26},
                              {54, 55, 56, 57, 58, 59, 60, 61, 62})};
  EXPECT_TRUE(may_be_strip(garment, 0));
  garment.seams.push_back(test::seam("side", {8, 17, 26}, {27, 36, 45}));
  EXPECT_FALSE(may_be_strip(garment, 0));
}

TEST(AroundPanels, TheTubeFitTellsHowFarAroundAStripIsSewn) {
  const PanelMesh garment = strips();
  // The partner's points go around from a half turn behind the middle on.
  const auto around = [](double turns) {
    return [turns](int p) -> std::optional<double> {
      return std::numbers::pi + turns * 2 * std::numbers::pi * ((p - 27) / 8.0 - 0.5);
    };
  };
  const TubeFit whole = tube_fit(garment, 0, around(1));
  EXPECT_NEAR(whole.share, 1, 1e-9);
  EXPECT_NEAR(std::abs(whole.turn), std::numbers::pi, 1e-9);
  EXPECT_EQ(whole.axis, PlacementAxis::plus_y);
  // The mean of cos(x) at nine places from a quarter of a turn before to a quarter behind.
  double half = 0;
  for (int k = -4; k <= 4; ++k) half += std::cos(std::numbers::pi * k / 8) / 9;
  EXPECT_NEAR(tube_fit(garment, 0, around(0.5)).share, half, 1e-9);
  EXPECT_LT(tube_fit(garment, 0, around(0)).share, 0.2);
  // The other way around, its right side lies outside where it is upside down.
  const TubeFit turned = tube_fit(garment, 0, around(-1));
  EXPECT_NEAR(turned.share, 1, 1e-9);
  EXPECT_EQ(turned.axis, PlacementAxis::minus_y);
}

}  // namespace around_panels_test
}  // namespace toile
