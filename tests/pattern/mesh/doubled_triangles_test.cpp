#include "pattern/mesh/doubled_triangles.h"

#include <gtest/gtest.h>

namespace toile {
namespace doubled_triangles_test {

/// Two panels of one triangle each; side 0-1 and side 1-2 can be sewn to the other's.
PanelMesh two_triangles() {
  PanelMesh garment;
  garment.flat = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 1}, {1, 0}};
  garment.placed.resize(6, Vec3::Zero());
  garment.triangles = {{0, 1, 2}, {3, 5, 4}};
  garment.panels = {{"one", "", 0, 0, 3, 0, 1}, {"two", "", 0, 3, 3, 1, 1}};
  garment.seams = {{"first", {0, 1}, {3, 4}, 1, 1}};
  return garment;
}

TEST(Doubled, OneSeamLaysNoTriangleOnAnother) {
  EXPECT_TRUE(doubled_triangles(two_triangles()).empty());
}

TEST(Doubled, TwoSeamsRoundACornerDo) {
  PanelMesh garment = two_triangles();
  garment.seams.push_back({"second", {1, 2}, {4, 5}, 1, 1});
  EXPECT_EQ(doubled_triangles(garment), (std::vector<int>{0, 1}));
}

}  // namespace doubled_triangles_test
}  // namespace toile
