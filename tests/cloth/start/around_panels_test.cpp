#include "cloth/start/around_panels.h"

#include <gtest/gtest.h>

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

}  // namespace around_panels_test
}  // namespace toile
