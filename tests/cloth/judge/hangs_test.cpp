#include "cloth/judge/hangs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cloth/judge/wear_check.h"
#include "tests/cloth/figure.h"

namespace toile {
namespace hangs_test {

/// A tube around the trunk whose points lie at the height and radius that `lies` gives for each
/// height on the flat panel.
DressedGarment hanging(const PanelMesh& garment, const std::function<Vec2(double)>& lies) {
  std::vector<Vec3> points = garment.placed;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec2 at = lies(garment.flat[p].y());
    points[p] *= at.y() / test::tube_radius;
    points[p].y() = at.x();
  }
  return test::as_dressed(garment, points);
}

/// A fold of 12 cm all around, its middle layer between the others.
Vec2 with_a_fold(double up) {
  if (up < 0.24) return {0.8 + up, 0.24};
  if (up < 0.36) return {1.04 - (up - 0.24), 0.23};
  return {0.92 + (up - 0.36), 0.22};
}

TEST(Hangs, ATubeHangsStraight) {
  const PanelMesh garment = test::tube();
  const DressedGarment dressed = test::as_dressed(garment, garment.placed);
  for (const PanelHang& hang : measure_hangs(garment, dressed, test::figure())) {
    EXPECT_NEAR(hang.area, test::pi * test::tube_radius * 0.6, 1e-9);
    EXPECT_EQ(hang.folded, 0);
    EXPECT_NEAR((hang.worn - Vec2::UnitY()).norm(), 0, 1e-9);
    EXPECT_NEAR((hang.placed - Vec2::UnitY()).norm(), 0, 1e-9);
    EXPECT_FALSE(hang.is_turned());
  }
}

TEST(Hangs, TheMiddleLayerOfAFoldHangsUpsideDown) {
  const PanelMesh garment = test::tube();
  const DressedGarment dressed = hanging(garment, with_a_fold);
  for (const PanelHang& hang : measure_hangs(garment, dressed, test::figure())) {
    EXPECT_NEAR(hang.folded / hang.area, 0.12 / 0.6, 0.03 / 0.6);
  }
  const WearFindings worn = check_worn(garment, dressed, test::figure());
  ASSERT_TRUE(worn.misplaced);
  EXPECT_NE(worn.misplaced->at.find("fold"), std::string::npos);
}

TEST(Hangs, BothHalvesOfAPonchoFaceOut) {
  PanelMesh garment;
  // From the front's hem over the shoulders to the back's hem.
  test::add_panel(garment, "poncho", test::grid(0.6, 1.2, 20, 40), [](const Vec2& p) {
    const double down = std::abs(p.y() - 0.6);
    return Vec3(p.x() - 0.3, 1.5 - down, p.y() < 0.6 ? 0.2 : -0.2);
  });
  const DressedGarment dressed = test::as_dressed(garment, garment.placed);
  const PanelHang hang = measure_hangs(garment, dressed, test::figure()).at(0);
  EXPECT_LT(hang.worn.norm(), 0.1);
  EXPECT_EQ(hang.folded, 0);
}

TEST(Hangs, APanelThatStartedTheOtherWayUpIsNamed) {
  PanelMesh garment = test::tube();
  const DressedGarment dressed = test::as_dressed(garment, garment.placed);
  const MeshedPanel& back = garment.panels[1];
  for (int p = back.first_point; p < back.first_point + back.points; ++p) {
    garment.placed[p].y() = 2.2 - garment.placed[p].y();
  }
  const WearFindings worn = check_worn(garment, dressed, test::figure());
  EXPECT_FALSE(worn.misplaced);
  EXPECT_EQ(worn.turned, std::vector<std::string>{"back"});
  // A pattern without places says nothing of it.
  garment.has_places = false;
  EXPECT_TRUE(check_worn(garment, dressed, test::figure()).turned.empty());
}

}  // namespace hangs_test
}  // namespace toile
