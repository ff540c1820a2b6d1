#include "cloth/judge/two_sides.h"

#include <gtest/gtest.h>

namespace toile {
namespace two_sides_test {

/// A ring of two panels, two quads each. With `turned`, the seam that closes the ring
/// joins each end to the other's upside down.
DressedGarment ring(bool turned, PanelMesh& garment) {
  garment.panels.resize(2);
  garment.panels[0].name = "front";
  garment.panels[1].name = "back";
  DressedGarment dressed;
  constexpr int columns = 4;  // two of each panel
  dressed.points.resize(2 * columns, Vec3::Zero());
  for (int c = 0; c < columns; ++c) {
    const int next = (c + 1) % columns;
    const bool turns = turned && next == 0;
    const int low = 2 * c;
    const int high = low + 1;
    const int next_low = 2 * next + (turns ? 1 : 0);
    const int next_high = 2 * next + (turns ? 0 : 1);
    dressed.triangles.push_back({low, next_low, next_high});
    dressed.triangles.push_back({low, next_high, high});
    for (int i = 0; i < 2; ++i) dressed.panel_of_triangle.push_back(c / 2);
  }
  return dressed;
}

TEST(TwoSides, ABandHasThemUnlessItIsSewnWithHalfATurn) {
  PanelMesh garment;
  const DressedGarment band = ring(false, garment);
  EXPECT_FALSE(one_sided_seam(garment, band));
  const DressedGarment moebius = ring(true, garment);
  const auto seam = one_sided_seam(garment, moebius);
  ASSERT_TRUE(seam);
  EXPECT_NE(seam->first, seam->second);
}

TEST(TwoSides, ALayeredPanelIsLeftOut) {
  PanelMesh garment;
  const DressedGarment moebius = ring(true, garment);
  garment.panels[1].layered = true;
  EXPECT_FALSE(one_sided_seam(garment, moebius));
}

}  // namespace two_sides_test
}  // namespace toile
