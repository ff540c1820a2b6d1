#include "cloth/start/narrow_leg_panels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cloth/start/constants.h"
#include "tests/cloth/figure.h"

namespace toile {
namespace narrow_leg_panels_test {

constexpr int columns = 4, rows = 2;
constexpr int points = (columns + 1) * (rows + 1);

/// A cuff 0.2 m wide before the left leg of figure(), with a flounce of `width` sewn to it. The
/// middle of both is at x = 0.1.
PanelMesh cuff_with_flounce(double width) {
  PanelMesh garment;
  const auto add = [&](const std::string& name, double wide, double y) {
    test::add_panel(garment, name, test::grid(wide, 0.1, columns, rows), [=](const Vec2& p) {
      return Vec3(0.1 - 0.5 * wide + p.x(), y + p.y(), 0.2);
    }).is = classify({"", BodyPart::left_leg});
  };
  add("cuff", 0.2, 0.3);
  add("flounce", width, 0.1);
  std::vector<int> hem, top;
  for (int i = 0; i <= columns; ++i) {
    hem.push_back(i);
    top.push_back(points + rows * (columns + 1) + i);
  }
  garment.seams = {test::seam("top", hem, top)};
  return garment;
}

TEST(NarrowLegPanels, AFlounceIsDrawnTogetherOnItsOwnSide) {
  const PanelMesh garment = cuff_with_flounce(0.5);
  std::vector<Vec3> placed = garment.placed;
  narrow_leg_panels(garment, test::figure(), placed);
  double inner = 1, outer = 0;
  for (int p = points; p < 2 * points; ++p) {
    inner = std::min(inner, placed[p].x());
    outer = std::max(outer, placed[p].x());
    EXPECT_EQ(placed[p].tail<2>(), garment.placed[p].tail<2>());
  }
  EXPECT_NEAR(inner, leg_panel_gap, 1e-12);
  EXPECT_NEAR(inner + outer, 0.2, 1e-12);  // its middle stays
  // The cuff, which ends at the plane, stays.
  EXPECT_TRUE(std::equal(placed.begin(), placed.begin() + points, garment.placed.begin()));
}

TEST(NarrowLegPanels, WhatKeepsToItsSideStays) {
  PanelMesh garment = cuff_with_flounce(0.2 + 1.9 * max_leg_panel_overlap);
  std::vector<Vec3> placed = garment.placed;
  narrow_leg_panels(garment, test::figure(), placed);
  EXPECT_EQ(placed, garment.placed);
  // And a wide panel of the torso, such as a skirt's front.
  garment = cuff_with_flounce(0.5);
  for (MeshedPanel& panel : garment.panels) panel.is = classify({"", BodyPart::torso});
  placed = garment.placed;
  narrow_leg_panels(garment, test::figure(), placed);
  EXPECT_EQ(placed, garment.placed);
}

}  // namespace narrow_leg_panels_test
}  // namespace toile
