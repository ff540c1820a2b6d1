#include "geometry/body/mannequin/loft.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace loft_test {

Loft cylinder(double squareness) {
  return Loft({},
              {{0.0, 0, 0, 0.10, 0.05, 0.08, squareness},
               {0.5, 0, 0, 0.10, 0.05, 0.08, squareness},
               {1.0, 0, 0, 0.10, 0.05, 0.08, squareness}},
              0.02);
}

TEST(Loft, ReachesItsHalfWidthFrontAndBack) {
  for (const double squareness : {2.0, 2.5}) {
    const Loft loft = cylinder(squareness);
    EXPECT_NEAR(loft.distance({0.10, 0.5, 0}), 0, 1e-12);
    EXPECT_NEAR(loft.distance({-0.10, 0.5, 0}), 0, 1e-12);
    EXPECT_NEAR(loft.distance({0, 0.5, 0.05}), 0, 1e-12);
    EXPECT_NEAR(loft.distance({0, 0.5, -0.08}), 0, 1e-12);
    // Straight off an axis of the section the distance is exact.
    EXPECT_NEAR(loft.distance({0, 0.5, 0.06}), 0.01, 1e-12);
    EXPECT_NEAR(loft.distance({0, 0.5, 0.04}), -0.01, 1e-12);
  }
  // The rounder of the two is the inner one where they differ.
  const Vec3 corner(0.075, 0.5, 0.035);
  EXPECT_LT(cylinder(2.5).distance(corner), cylinder(2.0).distance(corner));
}

TEST(Loft, EndsAtItsEndRows) {
  const Loft loft = cylinder(2);
  EXPECT_NEAR(loft.distance({0, 1.0, 0}), 0, 1e-12);
  EXPECT_LT(loft.distance({0, 0.99, 0}), 0);
  EXPECT_GT(loft.distance({0, 1.01, 0}), 0);
}

TEST(Loft, FarAwayIsFar) {
  const Loft loft = cylinder(2);
  EXPECT_GT(loft.distance({0.5, 0.5, 0}), Loft::far);
  EXPECT_LT(loft.distance({0.5, 0.5, 0}), 0.4);
  EXPECT_GT(loft.distance({0, 3, 0}), Loft::far);
}

TEST(Loft, ScalesOneRowAndFlowsThroughTheOthers) {
  Loft loft = cylinder(2);
  loft.scale(1, 1.2);
  EXPECT_NEAR(loft.distance({0.12, 0.5, 0}), 0, 1e-12);
  EXPECT_NEAR(loft.distance({0.10, 0.02, 0}), 0, 0.002) << "the end row keeps its width";
  EXPECT_LT(loft.distance({0.105, 0.25, 0}), 0);
}

TEST(Loft, IsADistanceToFirstOrder) {
  Loft loft = cylinder(2);
  loft.scale(1, 1.3);
  const Vec3 outside(0.09, 0.30, 0.05);
  constexpr double step = 1e-6;
  Vec3 slope;
  for (int i = 0; i < 3; ++i) {
    slope[i] = (loft.distance(outside + step * Vec3::Unit(i)) -
                loft.distance(outside - step * Vec3::Unit(i))) /
               (2 * step);
  }
  EXPECT_NEAR(slope.norm(), 1, 0.15);
}

TEST(Ellipsoid, OfEqualRadiiIsASphere) {
  const Ellipsoid sphere{{0.1, 0, 0}, {0.05, 0.05, 0.05}, 0.3};
  EXPECT_NEAR(sphere.distance({0.1, 0.08, 0}), 0.03, 1e-12);
  EXPECT_NEAR(sphere.distance({0.1, 0.03, 0}), -0.02, 1e-12);
}

TEST(Ellipsoid, TiltsAboutX) {
  const Ellipsoid tilted{{0, 0, 0}, {0.05, 0.10, 0.05}, 0.5};
  // Its long axis, y, leans towards +z.
  EXPECT_NEAR(tilted.distance({0, 0.10 * std::cos(0.5), 0.10 * std::sin(0.5)}), 0, 1e-12);
}

TEST(SmoothUnion, IsTheNearerOneAwayFromTheBlendAndNeverOutsideIt) {
  EXPECT_EQ(smooth_union(0.01, 0.05, 0.03), 0.01);
  EXPECT_EQ(smooth_union(0.05, 0.01, 0.03), 0.01);
  for (double b = -0.05; b < 0.05; b += 0.001) {
    EXPECT_LE(smooth_union(0.01, b, 0.03), std::min(0.01, b));
    EXPECT_GE(smooth_union(0.01, b, 0.03), std::min(0.01, b) - 0.03 / 6 - 1e-15);
    EXPECT_EQ(smooth_intersection(-0.01, -b, 0.03), -smooth_union(0.01, b, 0.03));
  }
}

}  // namespace loft_test
}  // namespace toile
