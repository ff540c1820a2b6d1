#include "cloth/dressing/carry_drape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/cloth/panels.h"

namespace toile {
namespace carry_drape_test {

constexpr double width = 0.4;
constexpr double height = 0.3;
constexpr double radius = 0.2;

/// Around a cylinder about y.
Vec3 rolled(const Vec2& p) {
  return {radius * std::sin(p.x() / radius), p.y(), radius * std::cos(p.x() / radius)};
}

PanelMesh sheet(double wide, double high, int columns, int rows) {
  return test::flat_panel(test::grid(wide, high, columns, rows));
}

DressedGarment drape_of(const PanelMesh& garment) {
  std::vector<Vec3> points;
  for (const Vec2& p : garment.flat) points.push_back(rolled(p));
  return as_dressed(garment, points, garment.triangles);
}

TEST(CarryDrape, TheSameGarmentKeepsItsPlaces) {
  const PanelMesh garment = sheet(width, height, 8, 6);
  const CarriedDrape carried = carry_drape(drape_of(garment), garment);
  ASSERT_EQ(carried.refusal, "");
  EXPECT_LT(carried.outside, 1e-9);
  for (std::size_t p = 0; p < garment.flat.size(); ++p) {
    EXPECT_LT((carried.points[p] - rolled(garment.flat[p])).norm(), 1e-12) << p;
  }
}

/// Chords of 1 cm stand off a circle of 20 cm by less than a tenth of a millimetre.
TEST(CarryDrape, AnotherMeshOfThePanelLiesOnTheSameSurface) {
  const PanelMesh other = sheet(width, height, 13, 17);
  const CarriedDrape carried = carry_drape(drape_of(sheet(width, height, 40, 30)), other);
  ASSERT_EQ(carried.refusal, "");
  EXPECT_LT(carried.outside, 1e-9);
  for (std::size_t p = 0; p < other.flat.size(); ++p) {
    EXPECT_LT((carried.points[p] - rolled(other.flat[p])).norm(), 1e-4) << p;
  }
}

TEST(CarryDrape, ALongerPanelGoesOnInThePlaneOfItsEdge) {
  const PanelMesh longer = sheet(width, height + 0.03, 8, 11);
  const CarriedDrape carried = carry_drape(drape_of(sheet(width, height, 40, 30)), longer);
  ASSERT_EQ(carried.refusal, "");
  EXPECT_NEAR(carried.outside, 0.03, 1e-9);
  EXPECT_EQ(carried.shifted, 0);
  for (std::size_t p = 0; p < longer.flat.size(); ++p) {
    EXPECT_NEAR(carried.points[p].y(), longer.flat[p].y(), 1e-9) << p;
    EXPECT_LT((carried.points[p] - rolled(longer.flat[p])).norm(), 2e-3) << p;
  }
}

TEST(CarryDrape, AnotherGarmentIsRefusedAndThatIsSaid) {
  const DressedGarment drape = drape_of(sheet(width, height, 8, 6));
  EXPECT_EQ(carry_drape(drape, sheet(width, height + 0.08, 8, 6)).refusal,
            "panel 'panel' reaches 8.0 cm beyond what it was");
  PanelMesh renamed = sheet(width, height, 8, 6);
  renamed.panels[0].name = "front";
  EXPECT_EQ(carry_drape(drape, renamed).refusal, "panel 'front' is new");
  DressedGarment more = drape;
  more.panels.emplace_back("pocket");
  EXPECT_EQ(carry_drape(more, sheet(width, height, 8, 6)).refusal, "panel 'pocket' is gone");
  EXPECT_EQ(carry_drape(more, sheet(width, height, 8, 6)).points.size(), 0U);
}

TEST(CarryDrape, ASeamThatWasNotThereIsRefused) {
  PanelMesh garment = sheet(width, height, 8, 6);
  const std::vector<int> left = test::side(garment.panels[0], 8, 6, false);
  const std::vector<int> right = test::side(garment.panels[0], 8, 6, true);
  garment.seams.push_back(test::seam("panel.3-panel.1", left, right));
  // The chord of 40 cm around the cylinder.
  EXPECT_EQ(carry_drape(drape_of(garment), garment).refusal,
            "the sides of seam panel.3-panel.1 are 33.7 cm apart");
}

TEST(CarryDrape, ATriangleWithoutAreaTellsNothing) {
  const PanelMesh garment = sheet(width, height, 8, 6);
  DressedGarment drape = drape_of(garment);
  // The corner's triangle collapses onto its diagonal in the flat panel.
  drape.flat[8] = drape.flat[17];
  const CarriedDrape carried = carry_drape(drape, garment);
  ASSERT_EQ(carried.refusal, "");
  for (const Vec3& p : carried.points) EXPECT_TRUE(p.allFinite());
}

/// Both sides of a sheet that is rolled into a tube are moved out by 1 cm.
TEST(CarryDrape, AMovedSeamStaysWhereItWas) {
  const double around = 2 * std::numbers::pi * radius;
  PanelMesh wider = sheet(around + 0.02, height, 40, 10);
  for (Vec2& p : wider.flat) p.x() -= 0.01;
  wider.seams.push_back(test::seam("panel.3-panel.1", test::side(wider.panels[0], 40, 10, false),
                                   test::side(wider.panels[0], 40, 10, true)));
  const CarriedDrape carried = carry_drape(drape_of(sheet(around, height, 200, 40)), wider);
  ASSERT_EQ(carried.refusal, "");
  EXPECT_NEAR(carried.outside, 0.01, 1e-9);
  EXPECT_NEAR(carried.shifted, 0.01, 1e-9);
  for (std::size_t p = 0; p < wider.flat.size(); ++p) {
    // What is between the seams is squeezed evenly.
    const double share = (wider.flat[p].x() + 0.01) / (around + 0.02);
    EXPECT_LT((carried.points[p] - rolled({share * around, wider.flat[p].y()})).norm(), 2e-3) << p;
  }
}

}  // namespace carry_drape_test
}  // namespace toile
