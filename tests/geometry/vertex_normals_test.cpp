#include "geometry/vertex_normals.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace toile {
namespace vertex_normals_test {

TEST(VertexNormals, OfASphereArePointsAway) {
  const TriangleMesh ball = test::sphere(0.3, 3);
  const std::vector<Vec3> normals = vertex_normals(ball.points, ball.triangles);
  ASSERT_EQ(normals.size(), ball.points.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_NEAR(normals[i].norm(), 1, 1e-12);
    EXPECT_GT(normals[i].dot(ball.points[i].normalized()), 0.999);
  }
}

/// A face of a cube is two triangles at one corner and one at another. Angles do not mind.
TEST(VertexNormals, DoNotMindHowAFaceIsCut) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  const std::vector<Vec3> normals =
      vertex_normals(points, {{0, 4, 1}, {0, 2, 4}, {0, 1, 3}, {0, 3, 2}});
  EXPECT_NEAR((normals[0] - Vec3(-1, -1, -1).normalized()).norm(), 0, 1e-12);
}

TEST(VertexNormals, APointWithoutAreaGetsUp) {
  const std::vector<Vec3> normals =
      vertex_normals({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {{0, 1, 2}});
  for (const Vec3& normal : normals) EXPECT_EQ(normal, Vec3::UnitY());
}

}  // namespace vertex_normals_test
}  // namespace toile
