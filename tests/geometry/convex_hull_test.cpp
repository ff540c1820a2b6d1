#include "geometry/convex_hull.h"

#include <gtest/gtest.h>

namespace toile {
namespace convex_hull_test {

TEST(ConvexHull, CornersRunCounterClockwiseFromTheLowestOfTheLeftmost) {
  const std::vector<Vec2> points = {{1, 1}, {0, 2}, {2, 0}, {1, 0}, {0, 0}, {2, 2}, {0, 1}};
  EXPECT_EQ(convex_hull(points), std::vector<int>({4, 2, 5, 1}));
}

TEST(ConvexHull, PointsThatAreThereTwiceCountOnce) {
  const std::vector<Vec2> points = {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}, {0, 1}};
  const std::vector<int> hull = convex_hull(points);
  ASSERT_EQ(hull.size(), 3U);
  EXPECT_EQ(points[hull[0]], Vec2(0, 0));
  EXPECT_EQ(points[hull[1]], Vec2(1, 0));
  EXPECT_EQ(points[hull[2]], Vec2(0, 1));
}

TEST(ConvexHull, ALineHasTwoCornersAndNothingHasNone) {
  EXPECT_EQ(convex_hull({{1, 1}, {0, 0}, {2, 2}}), std::vector<int>({1, 2}));
  EXPECT_TRUE(convex_hull({}).empty());
}

}  // namespace convex_hull_test
}  // namespace toile
