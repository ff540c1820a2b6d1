#include "pattern/import/weak_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/polygon.h"

namespace toile {
namespace weak_outline_test {

/// A piece of 40 x 60 cm; its lower side has `more` at the middle.
std::vector<Vec2> piece(const std::vector<Vec2>& more) {
  std::vector<Vec2> outline = {{0, 0}};
  outline.insert(outline.end(), more.begin(), more.end());
  for (const Vec2& point : {Vec2(0.4, 0), Vec2(0.4, 0.6), Vec2(0, 0.6)}) outline.push_back(point);
  return outline;
}

void expect_notch(const std::vector<Vec2>& more, double up) {
  const PlainOutline plain = plain_outline(piece(more));
  EXPECT_FALSE(first_crossing(plain.outline));
  EXPECT_NEAR(signed_area(plain.outline), 0.24, 1e-6);
  ASSERT_EQ(plain.notches.size(), 1u);
  EXPECT_LT((plain.notches[0].at - Vec2(0.2, 0)).norm(), 1e-4);
  EXPECT_NEAR(plain.notches[0].angle.value(), up * std::numbers::pi / 2, 0.02);
  EXPECT_TRUE(plain.holes.empty() && plain.slashes.empty());
}

TEST(WeakOutline, NotchesInTheShapeAreNotches) {
  expect_notch({{0.2, 0}, {0.2, 0.01}, {0.2, 0}}, 1);
  // Slits as programs write them, with a mouth that is open, or crossed.
  expect_notch({{0.19999, 0}, {0.2, 0.01}, {0.20001, 0}}, 1);
  expect_notch({{0.20001, 0}, {0.2, 0.01}, {0.19999, 0}}, 1);
  expect_notch({{0.1975, 0}, {0.2, 0.005}, {0.2025, 0}}, 1);
  expect_notch({{0.1975, 0}, {0.2, -0.005}, {0.2025, 0}}, -1);
  expect_notch({{0.1975, 0}, {0.1975, 0.005}, {0.2025, 0.005}, {0.2025, 0}}, 1);
}

TEST(WeakOutline, DartsAndStepsStayInTheOutline) {
  for (const std::vector<Vec2>& more : {
           std::vector<Vec2>{{0.185, 0}, {0.2, 0.1}, {0.215, 0}},
           {{0.196, 0}, {0.2, 0.04}, {0.204, 0}},
           {{0.2, 0}, {0.2, 0.005}, {0.205, 0.005}},
       }) {
    const PlainOutline plain = plain_outline(piece(more));
    EXPECT_EQ(plain.outline.size(), 4 + more.size());
    EXPECT_TRUE(plain.notches.empty());
  }
}

TEST(WeakOutline, ADartThatASlitJoinsToTheEdgeIsAHole) {
  const PlainOutline plain = plain_outline(
      piece({{0.2, 0}, {0.2, 0.05}, {0.19, 0.2}, {0.2, 0.4}, {0.21, 0.2}, {0.2, 0.05}, {0.2, 0}}));
  EXPECT_NEAR(signed_area(plain.outline), 0.24, 1e-9);
  ASSERT_EQ(plain.holes.size(), 1u);
  EXPECT_NEAR(signed_area(plain.holes[0]), -0.0035, 1e-9);
  EXPECT_TRUE(plain.notches.empty() && plain.slashes.empty());
}

TEST(WeakOutline, LongSlitsAreSlashesAndSmallCrossingsGo) {
  const PlainOutline slit = plain_outline(piece({{0.2, 0}, {0.2, 0.2}, {0.2, 0}}));
  ASSERT_EQ(slit.slashes.size(), 1u);
  EXPECT_NEAR((slit.slashes[0].back() - slit.slashes[0].front()).norm(), 0.2, 1e-9);
  EXPECT_FALSE(first_crossing(slit.outline));
  // The last side ends 0.01 mm beyond the first one.
  const PlainOutline crossed =
      plain_outline({{0, 0}, {0.4, 0}, {0.4, 0.6}, {1e-5, 0.6}, {1e-5, -1e-5}, {0, -1e-5}});
  EXPECT_FALSE(first_crossing(crossed.outline));
  EXPECT_NEAR(signed_area(crossed.outline), 0.24, 1e-5);
  EXPECT_TRUE(crossed.notches.empty() && crossed.holes.empty() && crossed.slashes.empty());
}

TEST(WeakOutline, WhatIsClothStaysCrossed) {
  for (const std::vector<Vec2>& crossed : {
           std::vector<Vec2>{{0, 0}, {0.3, 0.3}, {0.3, 0}, {0, 0.4}},
           {{0, 0}, {0.3, 0}, {0.1, 0.2}, {0.3, 0.4}, {0, 0.4}, {0.1, 0.2}},
       }) {
    EXPECT_TRUE(first_crossing(plain_outline(crossed).outline));
  }
}

}  // namespace weak_outline_test
}  // namespace toile
