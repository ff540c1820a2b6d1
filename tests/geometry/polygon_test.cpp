#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace toile {
namespace polygon_test {

using Outline = std::vector<Vec2>;
using Pair = std::array<int, 2>;

const Outline square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Outline, AreaIsPositiveCounterClockwise) {
  EXPECT_DOUBLE_EQ(signed_area(square), 1);
  EXPECT_DOUBLE_EQ(signed_area({square.rbegin(), square.rend()}), -1);
  Outline far;
  for (const Vec2& point : square) far.push_back(point * 0.01 + Vec2(1e6, 1e6));
  EXPECT_NEAR(signed_area(far), 1e-4, 1e-10);
}

TEST(Outline, SimplePolygonsCrossNowhere) {
  EXPECT_FALSE(first_crossing(square));
  EXPECT_FALSE(first_crossing({{0, 0}, {1, 0}, {2, 0}, {2, 1}}));  // straight on is no fold
}

TEST(Outline, CrossingsTouchesAndFoldsAreFound) {
  EXPECT_EQ(first_crossing({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), (Pair{0, 2}));
  // A vertex on a segment; a vertex twice; a fold back; a point twice in a row.
  EXPECT_TRUE(first_crossing({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
  EXPECT_TRUE(first_crossing({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}));
  EXPECT_EQ(first_crossing({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), (Pair{0, 1}));
  EXPECT_EQ(first_crossing({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), (Pair{1, 2}));
}

TEST(Outline, AgreesWithTestingEveryPair) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  int crossing = 0;
  for (int round = 0; round < 300; ++round) {
    Outline outline(6);
    for (Vec2& point : outline) point = Vec2(coordinate(random), coordinate(random));
    // Segments that are no neighbours cross when each one's ends lie on both sides of the other.
    const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) {
      return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0;
    };
    bool expected = false;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = i + 2; j < 6 - (i == 0 ? 1 : 0); ++j) {
        const Vec2 &a = outline[i], &b = outline[i + 1], &c = outline[j], &d = outline[(j + 1) % 6];
        expected = expected || (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b));
      }
    }
    crossing += expected;
    EXPECT_EQ(first_crossing(outline).has_value(), expected);
  }
  EXPECT_GT(crossing, 100);
  EXPECT_LT(crossing, 290);
}

TEST(Outline, InsideAndDistance) {
  const Outline notch = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  EXPECT_TRUE(inside(notch, {2, 0.5}));
  EXPECT_FALSE(inside(notch, {2, 2}));
  EXPECT_TRUE(inside(notch, {0.5, 2}));
  EXPECT_FALSE(inside(notch, {5, 1}));
  EXPECT_DOUBLE_EQ(distance_to_segment({1, 2}, {0, 0}, {4, 0}), 2);
  EXPECT_DOUBLE_EQ(distance_to_segment({-3, 4}, {0, 0}, {4, 0}), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment({3, 4}, {0, 0}, {0, 0}), 5);
}

}  // namespace polygon_test
}  // namespace toile
