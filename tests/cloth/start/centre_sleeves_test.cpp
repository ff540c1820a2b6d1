#include "cloth/start/centre_sleeves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cloth/figure.h"
#include "tests/support/shapes.h"

namespace toile {
namespace centre_sleeves_test {

using test::figure;

constexpr int cells = 4;
constexpr int points = (cells + 1) * (cells + 1);

/// An arm of figure() as a bar of 6 cm, level at y = 1.3, from the shoulder to the hand.
TriangleMesh arms() {
  TriangleMesh mesh;
  for (int i = 0; i <= 60; ++i) {
    const double x = 0.15 + 0.01 * i;
    for (const double y : {1.27, 1.33}) {
      for (const double z : {-0.03, 0.03}) {
        mesh.points.emplace_back(x, y, z);
        mesh.points.emplace_back(-x, y, z);
      }
    }
  }
  return mesh;
}

/// Front and back of a left sleeve, 20 cm before and 10 cm behind the arm. They are 12 cm wide from
/// y = `low` on. One seam is above, one below.
PanelMesh sleeve(double low) {
  PanelMesh garment;
  for (const double z : {0.2, -0.1}) {
    test::add_panel(garment, z > 0 ? "front" : "back", test::grid(0.3, 0.12, cells, cells),
                    [&](const Vec2& p) { return Vec3(0.3 + p.x(), low + p.y(), z); })
        .is = classify({"", BodyPart::left_arm});
  }
  std::vector<int> upper, lower, upper_behind, lower_behind;
  for (int i = 0; i <= cells; ++i) {
    lower.push_back(i);
    upper.push_back(cells * (cells + 1) + i);
    lower_behind.push_back(points + i);
    upper_behind.push_back(points + cells * (cells + 1) + i);
  }
  garment.seams = {test::seam("upper", upper, upper_behind),
                   test::seam("lower", lower, lower_behind)};
  return garment;
}

/// Heights of the sleeve's seams once it is centred.
std::pair<double, double> seams(double low, std::map<BodyPart, double>& moved) {
  const PanelMesh garment = sleeve(low);
  std::vector<Vec3> placed = garment.placed;
  const std::vector<BodyPart> parts(placed.size(), BodyPart::left_arm);
  moved = centre_sleeves(garment, parts, arms(), figure(), placed);
  double lowest = 2, highest = 0;
  for (std::size_t p = 0; p < placed.size(); ++p) {
    lowest = std::min(lowest, placed[p].y());
    highest = std::max(highest, placed[p].y());
    EXPECT_EQ(placed[p].z(), garment.placed[p].z());
  }
  return {lowest, highest};
}

TEST(CentreSleeves, ASleeveUnderItsArmIsLiftedAroundIt) {
  std::map<BodyPart, double> moved;
  // From 1.20 to 1.32: the upper seam would close 1 cm below the top of the arm.
  const auto [lowest, highest] = seams(1.20, moved);
  EXPECT_GT(highest, 1.33 + 0.01);
  EXPECT_LT(lowest, 1.27 - 0.01);
  EXPECT_GT(moved.at(BodyPart::left_arm), 0.02);
  EXPECT_FALSE(moved.contains(BodyPart::right_arm));
}

TEST(CentreSleeves, ASleeveAroundItsArmStays) {
  std::map<BodyPart, double> moved;
  const auto [lowest, highest] = seams(1.24, moved);
  EXPECT_NEAR(lowest, 1.24, 1e-12);
  EXPECT_NEAR(highest, 1.36, 1e-12);
  EXPECT_EQ(moved.at(BodyPart::left_arm), 0);
}

TEST(CentreSleeves, WithoutSeamsAroundTheArmNothingMoves) {
  PanelMesh garment = sleeve(1.20);
  garment.seams.clear();
  std::vector<Vec3> placed = garment.placed;
  const std::vector<BodyPart> parts(placed.size(), BodyPart::left_arm);
  EXPECT_TRUE(centre_sleeves(garment, parts, arms(), figure(), placed).empty());
  EXPECT_EQ(placed, garment.placed);
}

}  // namespace centre_sleeves_test
}  // namespace toile
