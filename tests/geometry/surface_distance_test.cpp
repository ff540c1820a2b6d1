#include "geometry/surface_distance.h"

#include <gtest/gtest.h>

#include "geometry/error.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace surface_distance_test {

TEST(SurfaceDistance, IsExactBesideFacesEdgesAndCornersOfACube) {
  const SurfaceDistance body(test::cube());
  EXPECT_NEAR(body.closest_point({0.5, 0.5, 1.25}).distance, 0.25, 1e-15);
  EXPECT_NEAR(body.closest_point({0.5, 1.3, 1.4}).distance, 0.5, 1e-15);
  EXPECT_NEAR(body.closest_point({2, 2, 2}).distance, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(body.closest_point({0.5, 0.5, 0.9}).distance, -0.1, 1e-15);
  const SurfacePoint at_corner = body.closest_point({2, 2, 2});
  EXPECT_NEAR((at_corner.point - Vec3(1, 1, 1)).norm(), 0, 1e-15);
  EXPECT_GT(at_corner.normal.dot(Vec3(1, 1, 1).normalized()), 0.999);
}

TEST(SurfaceDistance, KeepsItsSignWhereTheNearestFaceLooksAway) {
  // Close to a sharp edge, a point outside can lie behind the closest face's plane. Only the
  // averaged normal of the edge separates inside from outside.
  TriangleMesh wedge;
  wedge.points = {{0, 0, 0},      {0, 0, 1},     {-1, 0.05, 0},
                  {-1, -0.05, 0}, {-1, 0.05, 1}, {-1, -0.05, 1}};
  wedge.triangles = {{0, 2, 1}, {1, 2, 4}, {0, 1, 3}, {1, 5, 3},
                     {0, 3, 2}, {1, 4, 5}, {2, 3, 4}, {3, 5, 4}};
  const SurfaceDistance body(wedge);
  for (const double y : {-0.02, 0.0, 0.02}) {
    EXPECT_GT(body.closest_point({0.001, y, 0.5}).distance, 0) << "outside, at y = " << y;
  }
  EXPECT_LT(body.closest_point({-0.5, 0, 0.5}).distance, 0);
}

TEST(SurfaceDistance, GivesTheSameDistanceFromAnyHint) {
  const SurfaceDistance body(test::sphere(0.3, 4));
  const SurfacePoint far = body.closest_point({-1, 0.2, 0.1});
  for (int i = 0; i < 50; ++i) {
    const Vec3 query(0.01 * i, 0.3 - 0.007 * i, 0.1);
    EXPECT_DOUBLE_EQ(body.closest_point(query).distance, body.closest_point(query, far).distance);
  }
}

/// A sheet around the y axis, 30 cm across, from y = 0.5 to 1.
TriangleMesh sheet() {
  const DressedGarment cloth = test::cloth_tube(0.15, 0.15, 0.5, 1, 200, 10);
  return {cloth.points, cloth.triangles};
}

TEST(SurfaceDistance, ASheetHasAnOuterSideAndAnInnerOne) {
  const SurfaceDistance cloth(sheet());
  double largest = 0;
  for (int i = 0; i < 400; ++i) {
    const double angle = 0.7 * i;
    const double off = -0.1 + 0.2 * i / 399;
    const Vec3 p((0.15 + off) * std::sin(angle), 0.62 + 0.0006 * i, (0.15 + off) * std::cos(angle));
    largest = std::max(largest, std::abs(cloth.closest_point(p).distance - off));
  }
  // The faces are chords: 0.15 m times (1 - cos 0.9 degrees) is 0.02 mm.
  RecordProperty("error_mm", std::to_string(1000 * largest));
  EXPECT_LT(largest, 2e-5);
}

TEST(SurfaceDistance, BeyondItsBorderASheetIsToKeepAwayFrom) {
  const SurfaceDistance cloth(sheet());
  const auto at = [&](double radius, double y) {
    return cloth.closest_point({0, y, radius}).distance;
  };
  for (const double below : {0.001, 0.01, 0.1}) {
    EXPECT_NEAR(at(0.15, 0.5 - below), below, 1e-9) << "in line with the sheet";
    EXPECT_NEAR(at(0.17, 0.5 - below), std::hypot(0.02, below), 1e-9) << "before it";
    EXPECT_LE(std::abs(at(0.12, 0.5 - below)), std::hypot(0.03, below) + 1e-9) << "behind it";
  }
  // Behind the sheet the sign changes at 45 degrees, or 5 mm beyond the hem.
  EXPECT_NEAR(at(0.148, 0.498), 0, 2e-5);
  EXPECT_LT(at(0.148, 0.499), 0);
  EXPECT_GT(at(0.148, 0.497), 0);
  EXPECT_NEAR(at(0.10, 0.495), 0, 2e-5);
  EXPECT_GT(at(0.10, 0.45), 0.03);
}

TEST(SurfaceDistance, ASheetsSignDoesNotJumpAroundItsBorder) {
  const SurfaceDistance cloth(sheet());
  for (const double r : {0.002, 0.01, 0.04}) {
    // Around the hem from before the sheet to behind it, in steps of 0.36 degrees.
    double last = r, largest = 0;
    for (int i = 0; i <= 500; ++i) {
      const double angle = std::numbers::pi * i / 500;
      const Vec3 p(0, 0.5 - r * std::sin(angle), 0.15 + r * std::cos(angle));
      const double distance = cloth.closest_point(p).distance;
      EXPECT_LE(std::abs(distance), r + 1e-4);
      largest = std::max(largest, std::abs(distance - last));
      last = distance;
    }
    RecordProperty("largest_jump_mm_at_" + std::to_string(1000 * r),
                   std::to_string(1000 * largest));
    // The value goes from r to -r within 5 mm beyond the border. A step moves by 0.0063 r, so the
    // value changes by at most 2 r/5 mm times that.
    EXPECT_LT(largest, 0.02 * r * (1 + 2 * r / SurfaceDistance::border_bevel));
    EXPECT_NEAR(last, -r, 1e-4);
  }
}

TEST(SurfaceDistance, RefusesABodyWithoutTriangles) {
  EXPECT_THROW(SurfaceDistance(TriangleMesh{}), Error);
}

}  // namespace surface_distance_test
}  // namespace toile
