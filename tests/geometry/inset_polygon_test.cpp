#include "geometry/inset_polygon.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polygon.h"

namespace toile {
namespace inset_polygon_test {

TEST(InsetPolygon, CornersStaySharp) {
  // An L of 3 x 3 with a notch of 2 x 2: its reflex corner moves along the diagonal.
  const auto insets = inset_polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 0.1);
  ASSERT_EQ(insets.size(), 1u);
  ASSERT_EQ(insets[0].size(), 6u);
  EXPECT_NEAR(signed_area(insets[0]), 2.8 * 0.8 + 0.8 * 2.0, 1e-12);
  double nearest = 9;
  for (const Vec2& point : insets[0]) nearest = std::min(nearest, (point - Vec2(0.9, 0.9)).norm());
  EXPECT_LT(nearest, 1e-12);
}

TEST(InsetPolygon, FallsApartOrVanishes) {
  const std::vector<Vec2> dumbbell = {{0, 0}, {1, 0}, {1, 0.45}, {2, 0.45}, {2, 0}, {3, 0},
                                      {3, 1}, {2, 1}, {2, 0.55}, {1, 0.55}, {1, 1}, {0, 1}};
  EXPECT_EQ(inset_polygon(dumbbell, 0.02).size(), 1u);
  EXPECT_EQ(inset_polygon(dumbbell, 0.1).size(), 2u);
  EXPECT_TRUE(inset_polygon(dumbbell, 0.6).empty());
}

}  // namespace inset_polygon_test
}  // namespace toile
