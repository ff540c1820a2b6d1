#include "cloth/judge/slits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cloth/judge/verdict.h"
#include "tests/cloth/figure.h"
#include "tests/support/tubes.h"

namespace toile {
namespace slits_test {

/// The tube of two halves, whose right seam is sewn from the row `from` up to the row `to`.
PanelMesh tube_sewn(int from, int to) {
  PanelMesh garment = test::tube();
  for (std::vector<int>* side : {&garment.seams[1].a, &garment.seams[1].b}) {
    *side = std::vector<int>(side->begin() + from, side->begin() + to + 1);
  }
  return garment;
}

std::vector<Slit> slits_of(const PanelMesh& garment) {
  return find_slits(garment, test::as_dressed(garment, garment.placed));
}

TEST(Slits, ASewnTubeHasNone) { EXPECT_TRUE(slits_of(test::tube()).empty()); }

TEST(Slits, ASeamThatIsLeftOpenForAThirdIsOne) {
  // Rows are 3 cm high.
  const std::vector<Slit> slits = slits_of(tube_sewn(7, test::tube_rows));
  ASSERT_EQ(slits.size(), 1U);
  EXPECT_NEAR(slits[0].length, 0.21, 1e-9);
  EXPECT_NEAR(slits[0].tip.y(), 0.8 + 0.21, 1e-9);
  EXPECT_NE(slits[0].panel_a, slits[0].panel_b);
  EXPECT_NEAR(slits[0].rest, 2 * test::pi * test::tube_radius, 1e-9);
}

TEST(Slits, AnEdgeThatCurvesIsNoCorner) {
  PanelMesh garment = tube_sewn(10, test::tube_rows);
  // The side bends by 38 degrees on the way from the hem to its middle.
  for (Vec2& p : garment.flat) p.x() += 0.15 * std::sin(test::pi * p.y() / 0.6);
  const std::vector<Slit> slits = slits_of(garment);
  ASSERT_EQ(slits.size(), 1U);
  EXPECT_GT(slits[0].length, 0.3);
  EXPECT_LT(slits[0].length, 0.36);
}

TEST(Slits, ASlitThatIsNeededToPutItOnIsNone) {
  const PanelMesh garment = tube_sewn(7, test::tube_rows);
  const DressedGarment dressed = test::as_dressed(garment, garment.placed);
  const Skeleton skeleton = test::figure();
  const auto slits_on = [&](double radius) {
    return judge(garment, dressed, test::closed_tube(radius, radius, 1.7, 60), &skeleton, {})
        .slits.size();
  };
  EXPECT_EQ(slits_on(0.15), 1U);
  EXPECT_EQ(slits_on(0.26), 0U);
}

TEST(Slits, ASeamThatIsOpenInItsMiddleHasTwoEnds) {
  PanelMesh garment = tube_sewn(0, 5);
  garment.seams.push_back(garment.seams[1]);
  const PanelMesh whole = test::tube();
  for (const auto& [side, of] : {std::pair(&garment.seams[2].a, whole.seams[1].a),
                                 {&garment.seams[2].b, whole.seams[1].b}}) {
    *side = std::vector<int>(of.end() - 6, of.end());
  }
  EXPECT_EQ(slits_of(garment).size(), 2U);
}

TEST(Slits, AShortOneIsAVent) { EXPECT_TRUE(slits_of(tube_sewn(1, test::tube_rows)).empty()); }

/// Sews half of a waistband to the top of a half of the tube.
void add_band(PanelMesh& garment, const std::string& name, int half, double start) {
  test::add_panel(garment, name,
                  test::grid(test::pi * test::tube_radius, 0.04, test::tube_columns, 2),
                  [&](const Vec2& p) {
                    const double angle = start + p.x() / test::tube_radius;
                    return Vec3(test::tube_radius * std::sin(angle), 1.4 + p.y(),
                                test::tube_radius * std::cos(angle));
                  });
  std::vector<int> top;
  std::vector<int> bottom;
  for (int i = 0; i <= test::tube_columns; ++i) {
    const MeshedPanel& below = garment.panels[half];
    top.push_back(below.first_point + test::tube_rows * (test::tube_columns + 1) + i);
    bottom.push_back(garment.panels.back().first_point + i);
  }
  garment.seams.push_back(test::seam(name, top, bottom));
}

TEST(BandEnds, HalfAWaistbandHasTwo) {
  PanelMesh garment = test::tube();
  add_band(garment, "waistband_front", 0, -test::pi / 2);
  const std::vector<BandEnd> ends =
      find_band_ends(garment, test::as_dressed(garment, garment.placed));
  ASSERT_EQ(ends.size(), 2U);
  for (const BandEnd& end : ends) {
    EXPECT_EQ(end.band, "waistband_front");
    EXPECT_EQ(end.goes_on, "back");
    EXPECT_NEAR(end.at.y(), 1.4, 1e-9);
  }
}

TEST(BandEnds, AWholeWaistbandHasNone) {
  PanelMesh garment = test::tube();
  add_band(garment, "waistband_front", 0, -test::pi / 2);
  add_band(garment, "waistband_back", 1, test::pi / 2);
  const auto end_of = [&](int panel, bool right) {
    return test::side(garment.panels[panel], test::tube_columns, 2, right);
  };
  garment.seams.push_back(test::seam("left end", end_of(2, true), end_of(3, false)));
  garment.seams.push_back(test::seam("right end", end_of(3, true), end_of(2, false)));
  EXPECT_TRUE(find_band_ends(garment, test::as_dressed(garment, garment.placed)).empty());
}

TEST(BandEnds, ABandThatEndsWhereItsEdgeEndsHasNone) {
  PanelMesh garment = tube_sewn(0, 1);
  garment.seams.erase(garment.seams.begin() + 1);  // the right side is open, as a jacket's front
  add_band(garment, "waistband_front", 0, -test::pi / 2);
  add_band(garment, "waistband_back", 1, test::pi / 2);
  garment.seams.push_back(test::seam("left end",
                                     test::side(garment.panels[2], test::tube_columns, 2, true),
                                     test::side(garment.panels[3], test::tube_columns, 2, false)));
  EXPECT_TRUE(find_band_ends(garment, test::as_dressed(garment, garment.placed)).empty());
}

TEST(Slits, ALayeredPanelPlaysNoPart) {
  PanelMesh garment = tube_sewn(7, test::tube_rows);
  for (MeshedPanel& panel : garment.panels) panel.layered = true;
  EXPECT_TRUE(slits_of(garment).empty());
}

}  // namespace slits_test
}  // namespace toile
