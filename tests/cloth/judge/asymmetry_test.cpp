#include "cloth/judge/asymmetry.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/cloth/figure.h"

namespace toile {
namespace asymmetry_test {

std::optional<Asymmetry> measure(const PanelMesh& garment, const std::vector<Vec3>& points) {
  return measure_asymmetry(garment, test::as_dressed(garment, points), 0);
}

TEST(Asymmetry, ATubeIsItsOwnMirrorImage) {
  const PanelMesh garment = test::tube();
  const std::optional<Asymmetry> found = measure(garment, garment.placed);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->largest, 0, 1e-9);
}

TEST(Asymmetry, ATubeThatHangsLowerOnOneSide) {
  const PanelMesh garment = test::tube();
  std::vector<Vec3> points = garment.placed;
  for (Vec3& p : points) p.y() += 0.1 * p.x();
  const std::optional<Asymmetry> found = measure(garment, points);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->largest, 0.1 * 2 * test::tube_radius, 1e-6);
  // The mean over a quarter of a circle.
  EXPECT_NEAR(found->height, found->largest * 2 / test::pi, 2e-3);
}

TEST(Asymmetry, ATubeThatIsMovedAside) {
  const PanelMesh garment = test::tube();
  std::vector<Vec3> points = garment.placed;
  for (Vec3& p : points) p.x() += 0.01;
  const std::optional<Asymmetry> found = measure(garment, points);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->largest, 0.02, 1e-9);
  EXPECT_NEAR(found->across, 0.02, 1e-9);
}

TEST(Asymmetry, APatternWithoutMirrorImageHasNone) {
  PanelMesh garment = test::tube();
  garment.flat[test::tube_columns].x() += 0.02;  // one lower corner of the front
  EXPECT_FALSE(measure(garment, garment.placed));
}

TEST(Asymmetry, NorHasOneThatIsSewnOnOneSideOnly) {
  PanelMesh garment = test::tube();
  garment.seams.pop_back();
  std::vector<Vec3> points = garment.placed;
  // The open side gapes.
  for (int row = 0; row <= test::tube_rows; ++row) {
    points[row * (test::tube_columns + 1)].x() -= 0.1;
  }
  EXPECT_FALSE(measure(garment, points));
}

}  // namespace asymmetry_test
}  // namespace toile
