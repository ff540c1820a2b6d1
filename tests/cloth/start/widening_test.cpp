#include "cloth/start/widening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/cloth/figure.h"

namespace toile {
namespace widening_test {

constexpr int cells = 4;
constexpr int row = cells + 1;
constexpr double width = 0.2;  // metres, of each panel

/// Fronts and backs of a skirt around the legs of figure(), each of a left and a right half. Seam 0
/// is the wearer's left side, 1 the right side, 2 the middle of the front. Seam 3 runs across: the
/// left front's upper edge, to a band above it.
PanelMesh skirt() {
  PanelMesh garment;
  const auto add = [&](const std::string& name, double x, double y, double z) {
    test::add_panel(garment, name, test::grid(width, 0.4, cells, cells), [&](const Vec2& p) {
      // Seen from behind, the panel's right side out.
      return Vec3(z > 0 ? x + p.x() : x + width - p.x(), y + p.y(), z);
    }).is = classify({"", BodyPart::torso});
  };
  add("left_front", 0, 0.5, 0.2);
  add("right_front", -width, 0.5, 0.2);
  add("left_back", 0, 0.5, -0.2);
  add("right_back", -width, 0.5, -0.2);
  add("band", 0, 1.0, 0.2);
  const auto side = [&](int panel, bool end) {
    std::vector<int> points;
    for (int i = 0; i < row; ++i) points.push_back(panel * row * row + i * row + (end ? cells : 0));
    return points;
  };
  std::vector<int> top, bottom;
  for (int i = 0; i < row; ++i) {
    top.push_back(cells * row + i);
    bottom.push_back(4 * row * row + i);
  }
  garment.seams = {test::seam("left", side(0, true), side(2, false)),
                   test::seam("right", side(1, false), side(3, true)),
                   test::seam("middle", side(0, false), side(1, true)),
                   test::seam("waist", top, bottom)};
  return garment;
}

/// The panels once these seams were held apart, each time once.
std::vector<WidePanel> widened_by(const PanelMesh& garment,
                                  const std::vector<std::vector<int>>& held_seams) {
  std::vector<WidePanel> panels;
  for (const std::vector<int>& seams : held_seams) {
    std::vector<char> held(garment.placed.size(), 0);
    for (const int s : seams) {
      held[garment.seams[s].a[2]] = held[garment.seams[s].b[2]] = 1;  // one point is enough
    }
    widen(garment, garment.placed, test::figure(), held, 1.5, panels);
  }
  return panels;
}

/// x of the panel's edges, metres.
std::pair<double, double> span(const PanelMesh& garment, const std::vector<WidePanel>& panels,
                               int panel) {
  double left = -1;
  double right = 1;
  for (int p = panel * row * row; p < (panel + 1) * row * row; ++p) {
    const Vec3 moved = panels[panel].moved(garment.placed[p]);
    EXPECT_EQ(moved.tail<2>(), garment.placed[p].tail<2>());
    left = std::max(left, moved.x());
    right = std::min(right, moved.x());
  }
  return {right, left};
}

TEST(Widen, WhatIsHeldOnOneSideStaysOnTheOther) {
  const PanelMesh garment = skirt();
  const std::vector<WidePanel> panels = widened_by(garment, {{0}});
  for (const int panel : {0, 2}) {
    const auto [from, to] = span(garment, panels, panel);
    EXPECT_NEAR(from, 0, 1e-12);
    EXPECT_NEAR(to, 1.5 * width, 1e-12);
  }
  for (const int panel : {1, 3, 4}) EXPECT_EQ(panels[panel].factor, 1);
}

TEST(Widen, AgainWhereASeamIsHeldAgain) {
  const PanelMesh garment = skirt();
  const std::vector<WidePanel> panels = widened_by(garment, {{0, 1}, {1}});
  EXPECT_NEAR(span(garment, panels, 0).second, 1.5 * width, 1e-12);
  EXPECT_NEAR(span(garment, panels, 1).first, -1.5 * 1.5 * width, 1e-12);
  EXPECT_NEAR(span(garment, panels, 3).first, -1.5 * 1.5 * width, 1e-12);
}

TEST(Widen, OfEitherSideOfASeam) {
  const PanelMesh garment = skirt();
  std::vector<char> held(garment.placed.size(), 0);
  for (int p = 2 * row * row; p < 3 * row * row; ++p) held[p] = 1;  // a panel that the body cuts
  std::vector<WidePanel> panels;
  EXPECT_TRUE(widen(garment, garment.placed, test::figure(), held, 1.5, panels));
  EXPECT_EQ(panels[0].factor, 1.5);
  EXPECT_EQ(panels[2].factor, 1.5);
  EXPECT_FALSE(widen(garment, garment.placed, test::figure(),
                     std::vector<char>(garment.placed.size(), 0), 1.5, panels));
  EXPECT_EQ(panels[0].factor, 1.5);
}

TEST(Widen, SeamsInOnePlaneAndAcrossSayNothing) {
  for (const WidePanel& panel : widened_by(skirt(), {{2, 3}})) EXPECT_EQ(panel.factor, 1);
}

TEST(Widen, HeldOnBothSidesItsMiddleStays) {
  PanelMesh garment = skirt();
  // The middle of the front sewn to the back instead: a tube around the left leg alone.
  garment.seams[2].b.clear();
  for (int i = 0; i < row; ++i) garment.seams[2].b.push_back(2 * row * row + i * row + cells);
  const std::vector<WidePanel> panels = widened_by(garment, {{0, 2}});
  const auto [from, to] = span(garment, panels, 0);
  EXPECT_NEAR(from, width / 2 - 0.75 * width, 1e-12);
  EXPECT_NEAR(to, width / 2 + 0.75 * width, 1e-12);
}

}  // namespace widening_test
}  // namespace toile
