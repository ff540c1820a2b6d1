#include "cloth/ease/garment_levels.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/standing_figure.h"
#include "tests/support/tubes.h"

namespace toile {
namespace garment_levels_test {

const TriangleMesh body = test::closed_tube(0.15, 0.15, 1.7, 200);

TEST(GarmentLevels, TopEdgeAndHem) {
  const DressedGarment tube = test::cloth_tube(0.2, 0.2, 0.85, 1.15, 200, 10);
  const auto levels = measure_garment_levels(tube, body, test::figure(), worn_as(tube.panels));
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[0].name, "top edge");
  EXPECT_NEAR(levels[0].height, 1.15, 1e-9);
  EXPECT_NEAR(levels[0].garment, 2 * std::numbers::pi * 0.2, 1e-3);
  EXPECT_NEAR(levels[0].as_cut, 2, 1e-9);  // 200 cells of 1 cm
  ASSERT_TRUE(levels[0].body);
  EXPECT_NEAR(*levels[0].body, 2 * std::numbers::pi * 0.15, 1e-3);
  EXPECT_EQ(levels[1].name, "hem");
  EXPECT_NEAR(levels[1].height, 0.85, 1e-9);
}

TEST(GarmentLevels, BelowTheTrunkThereIsNoGirthOfTheBody) {
  const DressedGarment tube = test::cloth_tube(0.2, 0.2, 0.4, 1.0, 40, 10);
  const auto levels = measure_garment_levels(tube, body, test::figure(), worn_as(tube.panels));
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_TRUE(levels[0].body);
  EXPECT_FALSE(levels[1].body);
}

TEST(GarmentLevels, TheWaistSeamIsWhereSkirtAndTopMeet) {
  DressedGarment dress = test::cloth_tube(0.2, 0.2, 0.5, 1.2, 40, 14);
  // The lower ten rows of both panels become a skirt.
  dress.panels = {"bodice", "bodice_back", "skirt"};
  for (std::size_t t = 0; t < dress.triangles.size(); ++t) {
    double height = 0;
    for (const int p : dress.triangles[t]) height += dress.points[p].y() / 3;
    if (height < 1.0) dress.panel_of_triangle[t] = 2;
  }
  const auto levels = measure_garment_levels(dress, body, test::figure(), worn_as(dress.panels));
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[1].name, "waist seam");
  EXPECT_NEAR(levels[1].height, 1.0, 1e-9);
  EXPECT_NEAR(levels[1].as_cut, 0.4, 1e-9);
  EXPECT_EQ(levels[0].panels, (std::vector<int>{0, 1}));
  EXPECT_EQ(levels[1].panels, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(levels[2].panels, std::vector<int>{2});
}

TEST(GarmentLevels, ATubeBesideTheBodyHasNone) {
  DressedGarment tube = test::cloth_tube(0.1, 0.1, 0.5, 1.0, 40, 10);
  for (Vec3& p : tube.points) p.x() += 0.6;
  EXPECT_TRUE(measure_garment_levels(tube, body, test::figure(), worn_as(tube.panels)).empty());
}

TEST(GarmentLevels, ASleeveHasACuffAndAnArmhole) {
  DressedGarment sleeve = test::cloth_tube(0.08, 0.08, 0.2, 0.6, 40, 10);
  for (Vec3& p : sleeve.points) p = Vec3(p.y(), 1.3 - p.x(), p.z());
  TriangleMesh arm = test::closed_tube(0.04, 0.04, 0.8, 200);
  for (Vec3& p : arm.points) p = Vec3(p.y(), 1.3 - p.x(), p.z());
  const auto levels = measure_garment_levels(sleeve, arm, test::figure(), worn_as(sleeve.panels));
  ASSERT_EQ(levels.size(), 2U);
  for (const GarmentLevel& level : levels) {
    EXPECT_TRUE(level.is_of_limb);
    EXPECT_NEAR(level.as_cut, 0.4, 1e-9);
    if (level.name == "left armhole") {
      EXPECT_FALSE(level.body);
    } else {
      EXPECT_EQ(level.name, "left cuff");
      ASSERT_TRUE(level.body);
      EXPECT_NEAR(*level.body, 2 * std::numbers::pi * 0.04, 1e-3);
    }
  }
}

}  // namespace garment_levels_test
}  // namespace toile
