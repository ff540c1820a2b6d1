#include "cloth/judge/tight_regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"

namespace toile {
namespace tight_regions_test {

constexpr double pi = std::numbers::pi;
constexpr double limit = 0.01;

Scene limited() {
  Scene scene;
  scene.strain_limit = limit;
  return scene;
}

/// 20 x 10 cm in squares of 1 cm, of which each point has moved by `stretch(p)` metres along y.
/// Only the yarns along y are multipliers: those across lie askew where that differs from column to
/// column.
class Sheet : public testing::Test {
 protected:
  template <typename Stretch>
  TightRegions regions_of(const Stretch& stretch, double multiplier = max_limit_multiplier) {
    garment = test::flat_panel(test::grid(0.2, 0.1, 20, 10));
    garment.panels[0].grain = grain;
    for (Vec3& p : garment.placed) p.y() += stretch(p);
    const GarmentModel model = compile(garment, limited(), garment.placed);
    const LimitMultiplier along_y =
        grain == 0 ? LimitMultiplier{0, multiplier, 0} : LimitMultiplier{multiplier, 0, 0};
    const std::vector<LimitMultiplier> multipliers(garment.triangles.size(), along_y);
    return tight_regions(garment, point_positions(model, model.start), limit, multipliers);
  }

  PanelMesh garment;
  double grain = 0;
};

/// A sheet of 20 x 10 cm whose left part, `wide` metres, is stretched by `strain` along y.
std::vector<TightRegion> overstretched_part(double wide, double strain) {
  const PanelMesh sheet = test::flat_panel(test::grid(0.2, 0.1, 20, 10));
  std::vector<Vec3> points = sheet.placed;
  for (Vec3& p : points) {
    if (p.x() < wide + 1e-6) p.y() *= 1 + strain;
  }
  return overstretched(sheet, points);
}

TEST(Overstretched, IsMoreThanAHandsBreadthSquareBeyondAQuarter) {
  ASSERT_EQ(overstretched_part(0.13, 0.3).size(), 1U);
  const TightRegion part = overstretched_part(0.13, 0.3).front();
  EXPECT_TRUE(part.along_warp);
  EXPECT_GT(part.area, 0.0129);
  EXPECT_LT(part.area, 0.0141);
  // Beyond a quarter, along the 10 cm of the sheet.
  EXPECT_NEAR(part.missing, 0.1 * 0.05, 0.0002);
  EXPECT_TRUE(overstretched_part(0.08, 0.3).empty());
  EXPECT_TRUE(overstretched_part(0.13, 0.24).empty());
  EXPECT_TRUE(overstretched_part(0.13, -0.5).empty());
}

/// 5 % longer from y = 2 to 6 cm, where x is from 4 to 8 cm or above 14 cm.
double two_patches(const Vec3& p) {
  const bool tight = (p.x() > 0.039 && p.x() < 0.081) || p.x() > 0.139;
  return tight ? 0.05 * (std::clamp(p.y(), 0.02, 0.06) - 0.02) : 0;
}

TEST_F(Sheet, NamesWhereHowLargeAndHowMuchIsMissing) {
  const TightRegions found = regions_of(two_patches);
  ASSERT_EQ(found.regions.size(), 2U);
  EXPECT_EQ(found.specks, 0);
  double area = 0;
  for (const TightRegion& region : found.regions) {
    EXPECT_EQ(region.panel, "panel");
    EXPECT_TRUE(region.along_warp);
    EXPECT_NEAR(region.largest, 0.05, 1e-9);
    EXPECT_NEAR(region.mean, 0.05, 1e-9);
    EXPECT_NEAR(region.missing, 0.04 * (0.05 - limit), 1e-9);
    // Worn, its middle has come up by half of what it is longer.
    EXPECT_NEAR(region.flat.y(), 0.04, 1e-3);
    EXPECT_NEAR(region.height, 0.041, 1e-3);
    area += region.area;
  }
  // Each of 5 and 7 columns of points strains the triangles on its sides; the last one has one
  // side.
  EXPECT_NEAR(area, 0.04 * (0.05 + 0.065), 1e-9);
  const double left = std::min(found.regions[0].flat.x(), found.regions[1].flat.x());
  const double right = std::max(found.regions[0].flat.x(), found.regions[1].flat.x());
  EXPECT_NEAR(left, 0.06, 1e-9);
  EXPECT_NEAR(right, (6 * 0.165 + 0.5 * (0.2 - 0.01 / 3)) / 6.5, 1e-9);
}

TEST_F(Sheet, WarpAndWeftAreThePanelsOwn) {
  grain = pi / 2;  // the warp lies along x
  for (const TightRegion& region : regions_of(two_patches).regions) EXPECT_FALSE(region.along_warp);
  EXPECT_EQ(regions_of(two_patches).regions.size(), 2U);
}

TEST_F(Sheet, TheMostStrainedIsFirst) {
  const TightRegions found =
      regions_of([](const Vec3& p) { return two_patches(p) * (p.x() > 0.1 ? 1.6 : 1); });
  ASSERT_EQ(found.regions.size(), 2U);
  EXPECT_NEAR(found.regions[0].largest, 0.08, 1e-9);
  EXPECT_GT(found.regions[0].flat.x(), 0.1);
  EXPECT_NEAR(found.regions[1].largest, 0.05, 1e-9);
}

TEST_F(Sheet, WhatIsNotHeldToTheUtmostIsNotTightButUnfinished) {
  EXPECT_TRUE(regions_of(two_patches, 0.99 * max_limit_multiplier).regions.empty());
}

TEST_F(Sheet, TenPercentOfTheLimitAreWithinIt) {
  EXPECT_TRUE(regions_of([](const Vec3& p) { return 0.0109 * p.y(); }).regions.empty());
  EXPECT_EQ(regions_of([](const Vec3& p) { return 0.0111 * p.y(); }).regions.size(), 1U);
}

TEST_F(Sheet, SpecksAreOnlyCounted) {
  // Two of the corners, of which each strains one triangle of half a square centimetre.
  const auto prick = [](const Vec3& p) {
    return p.y() < 1e-3 && (p.x() < 1e-3 || p.x() > 0.199) ? -0.0005 : 0;
  };
  const TightRegions found = regions_of(prick);
  EXPECT_TRUE(found.regions.empty());
  EXPECT_EQ(found.specks, 2);
}

/// One panel of stiff cloth, sewn to a tube around a cylinder, multipliers to 1 % of strain.
TightRegions drawn_over(double too_small) {
  constexpr double radius = 0.15, offset = 0.002;
  constexpr int columns = 108, rows = 8;
  static const Collider body{test::closed_tube(radius, radius, 0.5, 600)};
  const double girth = 2 * pi * (radius + offset) / (1 + too_small);
  PanelMesh garment;
  test::add_panel(garment, "tube", test::grid(girth, 0.08, columns, rows), [&](const Vec2& p) {
    const double angle = 2 * pi * p.x() / girth;
    const double r = radius + 0.004;
    return Vec3(r * std::sin(angle), 0.2 + p.y(), r * std::cos(angle));
  });
  garment.seams = {test::seam("", test::side(garment.panels[0], columns, rows, false),
                              test::side(garment.panels[0], columns, rows, true))};
  Scene scene = limited();
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  scene.self_contact = false;
  scene.fabric.stretch_warp = scene.fabric.stretch_weft = 5000;
  const GarmentModel model = compile(garment, scene, garment.placed);
  RelaxOptions options;
  options.gravity = 0;
  options.friction = false;
  options.max_iterations = 8000;
  options.stop_median = options.stop_rms = 0.02;
  std::vector<Vec3> x = model.start;
  const RelaxReport report = relax(model, options, x);
  const TightRegions found =
      tight_regions(garment, point_positions(model, x), limit, report.warm_start.multipliers);
  for (const TightRegion& region : found.regions) {
    std::cout << 100 * too_small << " % too small: " << 100 * region.mean << " % on average, "
              << 100 * region.largest << " % at most, " << 1e4 * region.area << " cm2, "
              << 100 * region.missing << " of " << 100 * girth << " cm missing\n";
    EXPECT_FALSE(region.along_warp);
    EXPECT_NEAR(region.area, girth * 0.08, 0.02 * girth * 0.08);
    EXPECT_NEAR(region.missing / girth, too_small - limit, 0.1 * (too_small - limit));
    EXPECT_NEAR(region.height, 0.24, 0.005);
    EXPECT_NEAR(region.flat.x(), girth / 2, 0.001);
  }
  EXPECT_EQ(found.specks, 0);
  return found;
}

TEST(TightTube, LacksItsGirthButForTheLimit) { EXPECT_EQ(drawn_over(0.05).regions.size(), 1U); }

TEST(TightTube, HasNoneWhereItFits) {
  EXPECT_TRUE(drawn_over(0.008).regions.empty());
  EXPECT_TRUE(drawn_over(-0.05).regions.empty());
}

}  // namespace tight_regions_test
}  // namespace toile
