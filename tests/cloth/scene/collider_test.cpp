#include "cloth/scene/collider.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/tubes.h"

namespace toile {
namespace collider_test {

TriangleMesh tube_at(double radius, double low, double high) {
  const DressedGarment cloth = test::cloth_tube(radius, radius, low, high, 120, 8);
  return {cloth.points, cloth.triangles};
}

TEST(Collider, EachLayerJoinsTheSurface) {
  const TriangleMesh body = test::closed_tube(0.05, 0.05, 0.4, 120);
  Collider collider(body);
  const DistanceGrid& grid = collider.grid();
  EXPECT_TRUE(collider.cloth().triangles.empty());
  EXPECT_EQ(collider.surface().triangles, body.triangles);
  EXPECT_NEAR(collider.distance({0, 0.2, 0.1}), 0.05, 1e-12);

  const TriangleMesh first = tube_at(0.053, 0.1, 0.25);
  const TriangleMesh second = tube_at(0.07, 0.15, 0.3);
  collider.add_layer(first);
  collider.add_layer(second);
  const std::size_t points = body.points.size() + first.points.size() + second.points.size();
  EXPECT_EQ(collider.surface().points.size(), points);
  EXPECT_EQ(collider.surface().triangles.size(),
            body.triangles.size() + first.triangles.size() + second.triangles.size());
  EXPECT_EQ(collider.cloth().triangles.size(), first.triangles.size() + second.triangles.size());
  EXPECT_EQ(collider.body().points, body.points);
  // Facets face outward, and stand on the points that they stood on.
  for (std::size_t t = body.triangles.size(); t < collider.surface().triangles.size(); ++t) {
    const Triangle& corners = collider.surface().triangles[t];
    const Vec3& a = collider.surface().points[corners[0]];
    const Vec3& b = collider.surface().points[corners[1]];
    const Vec3& c = collider.surface().points[corners[2]];
    const Vec3 middle = (a + b + c) / 3;
    const Vec3 normal = (b - a).cross(c - a).normalized();
    EXPECT_GT(normal.dot(Vec3(middle.x(), 0, middle.z()).normalized()), 0.99);
  }

  // Levels: only the first; both; only the second; bare skin.
  double largest = 0;
  for (const auto& [y, surface] : {std::pair(0.12, 0.053), std::pair(0.2, 0.07),
                                   std::pair(0.27, 0.07), std::pair(0.05, 0.05)}) {
    for (const double off : {-0.01, -0.001, 0.002, 0.008}) {
      const Vec3 p(0, y, surface + off);
      EXPECT_NEAR(collider.distance(p), off, 1e-5) << y;
      largest = std::max(largest, std::abs(grid.at(p).distance - collider.distance(p)));
    }
  }
  RecordProperty("grid_error_mm", std::to_string(1000 * largest));
  EXPECT_LT(largest, 1e-4);
}

}  // namespace collider_test
}  // namespace toile
