#include "geometry/border_loops.h"

#include <gtest/gtest.h>

namespace toile {
namespace border_loops_test {

/// Five by five squares, each two triangles, without those for which `is_hole` says so.
template <typename IsHole>
std::vector<Triangle> sheet(const IsHole& is_hole) {
  std::vector<Triangle> triangles;
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      if (is_hole(x, y)) continue;
      const int p = y * 6 + x;
      triangles.push_back({p, p + 1, p + 7});
      triangles.push_back({p, p + 7, p + 6});
    }
  }
  return triangles;
}

TEST(BorderLoops, ASheetHasOneThatPassesAllItsBorder) {
  const auto loops = border_loops(sheet([](int, int) { return false; }), 36);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].size(), 20U);
}

TEST(BorderLoops, AHoleHasItsOwn) {
  const auto loops = border_loops(sheet([](int x, int y) { return x == 2 && y == 2; }), 36);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].size(), 20U);
  EXPECT_EQ(loops[1].size(), 4U);
}

TEST(BorderLoops, HolesThatMeetInAPointAreOne) {
  const auto loops =
      border_loops(sheet([](int x, int y) { return x == y && (x == 1 || x == 2); }), 36);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[1].size(), 8U);
}

TEST(BorderLoops, AClosedSurfaceHasNone) {
  EXPECT_TRUE(border_loops({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, 4).empty());
}

}  // namespace border_loops_test
}  // namespace toile
