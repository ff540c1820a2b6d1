#include "geometry/body_distance.h"

#include <gtest/gtest.h>

#include "geometry/error.h"
#include "tests/support/shapes.h"

namespace toile {
namespace {

TEST(BodyDistance, IsExactBesideFacesEdgesAndCornersOfACube) {
  const BodyDistance body(test::cube());
  EXPECT_NEAR(body.nearest({0.5, 0.5, 1.25}).distance, 0.25, 1e-15);
  EXPECT_NEAR(body.nearest({0.5, 1.3, 1.4}).distance, 0.5, 1e-15);
  EXPECT_NEAR(body.nearest({2, 2, 2}).distance, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(body.nearest({0.5, 0.5, 0.9}).distance, -0.1, 1e-15);
  const BodyPoint at_corner = body.nearest({2, 2, 2});
  EXPECT_NEAR((at_corner.point - Vec3(1, 1, 1)).norm(), 0, 1e-15);
  EXPECT_GT(at_corner.normal.dot(Vec3(1, 1, 1).normalized()), 0.999);
}

TEST(BodyDistance, KeepsItsSignWhereTheNearestFaceLooksAway) {
  // Just off a sharp edge the nearest face's own plane can have the point on its other side; only
  // the averaged normal of the edge tells inside from outside.
  TriangleMesh wedge;
  wedge.points = {{0, 0, 0},      {0, 0, 1},     {-1, 0.05, 0},
                  {-1, -0.05, 0}, {-1, 0.05, 1}, {-1, -0.05, 1}};
  wedge.triangles = {{0, 2, 1}, {1, 2, 4}, {0, 1, 3}, {1, 5, 3},
                     {0, 3, 2}, {1, 4, 5}, {2, 3, 4}, {3, 5, 4}};
  const BodyDistance body(wedge);
  for (const double y : {-0.02, 0.0, 0.02}) {
    EXPECT_GT(body.nearest({0.001, y, 0.5}).distance, 0) << "outside, at y = " << y;
  }
  EXPECT_LT(body.nearest({-0.5, 0, 0.5}).distance, 0);
}

TEST(BodyDistance, GivesTheSameDistanceFromAnyHint) {
  const BodyDistance body(test::sphere(0.3, 4));
  const BodyPoint far = body.nearest({-1, 0.2, 0.1});
  for (int i = 0; i < 50; ++i) {
    const Vec3 query(0.01 * i, 0.3 - 0.007 * i, 0.1);
    EXPECT_DOUBLE_EQ(body.nearest(query).distance, body.nearest(query, far).distance);
  }
}

TEST(BodyDistance, RefusesABodyWithoutTriangles) {
  EXPECT_THROW(BodyDistance(TriangleMesh{}), Error);
}

}  // namespace
}  // namespace toile
