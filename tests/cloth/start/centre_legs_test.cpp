#include "cloth/start/centre_legs.h"

#include <gtest/gtest.h>

#include "cloth/start/constants.h"
#include "tests/cloth/figure.h"

namespace toile {
namespace centre_legs_test {

constexpr int cells = 4;
constexpr int points = (cells + 1) * (cells + 1);

/// Front and back of the left leg of figure(), whose bones are at x = 0.1. They reach from `inner`
/// to `outer` and from the ankle to the thigh, with a seam on either side.
PanelMesh leg(double inner, double outer) {
  PanelMesh garment;
  for (const double z : {0.2, -0.2}) {
    test::add_panel(garment, z > 0 ? "front" : "back", test::grid(outer - inner, 0.5, cells, cells),
                    [&](const Vec2& p) { return Vec3(inner + p.x(), 0.2 + p.y(), z); })
        .is = classify({"", BodyPart::left_leg});
  }
  std::vector<int> in, out, in_behind, out_behind;
  for (int i = 0; i <= cells; ++i) {
    in.push_back(i * (cells + 1));
    out.push_back(i * (cells + 1) + cells);
    in_behind.push_back(points + in.back());
    out_behind.push_back(points + out.back());
  }
  garment.seams = {test::seam("in", in, in_behind), test::seam("out", out, out_behind)};
  return garment;
}

/// Metres to the left that the panels moved; they move as one.
double shift(const PanelMesh& garment) {
  std::vector<Vec3> placed = garment.placed;
  centre_legs(garment, test::figure(), placed);
  const Vec3 moved = placed[0] - garment.placed[0];
  for (std::size_t p = 0; p < placed.size(); ++p) {
    EXPECT_NEAR((placed[p] - garment.placed[p] - moved).norm(), 0, 1e-12);
  }
  EXPECT_NEAR(moved.tail<2>().norm(), 0, 1e-12);
  return moved.x();
}

TEST(CentreLegs, AnInnerSeamOutsideOfTheBonesComesInside) {
  EXPECT_NEAR(shift(leg(0.12, 0.35)), 0.1 - leg_seam_clearance - 0.12, 1e-9);
}

TEST(CentreLegs, AnOuterSeamInsideOfTheBonesComesOutside) {
  EXPECT_NEAR(shift(leg(-0.15, 0.08)), 0.1 + leg_seam_clearance - 0.08, 1e-9);
}

TEST(CentreLegs, ALegBetweenItsSeamsStays) {
  EXPECT_EQ(shift(leg(0.09, 0.3)), 0);
  EXPECT_EQ(shift(leg(0.0, 0.2)), 0);
}

TEST(CentreLegs, PanelsTooNarrowForTheLegStay) { EXPECT_EQ(shift(leg(0.12, 0.14)), 0); }

TEST(CentreLegs, OtherPartsAndBodiesWithoutHipsStay) {
  PanelMesh garment = leg(0.12, 0.35);
  Skeleton torso = test::figure();
  torso.joints.erase("left_hip");
  std::vector<Vec3> placed = garment.placed;
  centre_legs(garment, torso, placed);
  EXPECT_EQ(placed, garment.placed);
  for (MeshedPanel& panel : garment.panels) panel.is = classify({"", BodyPart::torso});
  EXPECT_EQ(shift(garment), 0);
}

}  // namespace centre_legs_test
}  // namespace toile
