#include "geometry/intersections.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace toile {
namespace {

TEST(Intersections, FindNoneInAClosedSurface) {
  EXPECT_TRUE(self_intersections(test::cube()).empty());
  EXPECT_TRUE(self_intersections(test::sphere(0.5, 4)).empty());
}

TEST(Intersections, OfTwoMeshesCountTouchingToo) {
  TriangleMesh floor;
  floor.points = {{-1, 1, -1}, {3, 1, -1}, {-1, 1, 3}};
  floor.triangles = {{0, 2, 1}};
  EXPECT_FALSE(intersections(test::cube(), floor).empty()) << "rests on the cube's top";
  for (Vec3& p : floor.points) p.y() = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(intersections(test::cube(), floor).empty()) << "one bit above it";
  for (Vec3& p : floor.points) p.y() = 0.5;
  EXPECT_EQ(intersections(test::cube(), floor).size(), 8u) << "cuts the four sides' triangles";
}

TEST(Intersections, SeeAFoldOverASharedVertex) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.4, 0.3, 0.5}, {0.4, 0.3, -0.5}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(self_intersections(mesh), (std::vector<TrianglePair>{{0, 1}}));
  mesh.points[3] = {-0.4, -0.3, 0.5};
  mesh.points[4] = {-0.4, -0.3, -0.5};
  EXPECT_TRUE(self_intersections(mesh).empty());
}

TEST(Intersections, SeeAHingeFoldedFlatOntoItself) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0.6, 0.5, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(self_intersections(mesh).size(), 1u);
  mesh.points[3].z() = 1e-300;
  EXPECT_TRUE(self_intersections(mesh).empty()) << "open by the smallest angle";
  mesh.points[3] = {0.6, -0.5, 0};
  EXPECT_TRUE(self_intersections(mesh).empty()) << "flat";
}

TEST(Intersections, SeeDuplicateFaces) {
  TriangleMesh mesh = test::cube();
  mesh.triangles.push_back(mesh.triangles.front());
  EXPECT_EQ(self_intersections(mesh).size(), 1u);
}

}  // namespace
}  // namespace toile
