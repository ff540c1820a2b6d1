#include "geometry/intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

#include "tests/support/shapes.h"

namespace toile {
namespace intersections_test {

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

/// Triangles with two corners in one place, with three on a line, and with all in one place.
TEST(Intersections, TrianglesWithoutAreaAreSegmentsAndPoints) {
  TriangleMesh flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}};
  const auto meets = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const TriangleMesh thin{{a, b, c}, {{0, 1, 2}}};
    const bool met = !intersections(flat, thin).empty();
    EXPECT_EQ(!intersections(thin, flat).empty(), met);
    EXPECT_EQ(!self_intersections(test::together(flat, thin)).empty(), met);
    return met;
  };
  const Vec3 below(0.25, 0.25, -1), in(0.25, 0.25, 0), above(0.25, 0.25, 1), far(0.75, 0.75, 1);
  const Vec3 beside(0.75, 0.75, -1);
  EXPECT_TRUE(meets(below, below, above));
  EXPECT_TRUE(meets(above, below, 0.5 * (below + above)));
  EXPECT_TRUE(meets(below, above, in));
  EXPECT_FALSE(meets(far, far, beside)) << "its box meets the triangle's, it does not";
  EXPECT_FALSE(meets(far, beside, 0.5 * (far + beside)));
  EXPECT_FALSE(meets(above, above, Vec3(0.25, 0.25, 1e-9)));
  EXPECT_TRUE(meets(in, in, in));
  EXPECT_FALSE(meets(Vec3(0.75, 0.75, 0), Vec3(0.75, 0.75, 0), Vec3(0.75, 0.75, 0)));
  EXPECT_TRUE(meets(Vec3(-1, 0, 0), Vec3(0.5, 0, 0), Vec3(-1, 0, 0))) << "along an edge";
}

/// A closed surface with one edge split open and closed by two triangles without area.
TEST(Intersections, ASplitEdgeMeetsNothingNew) {
  TriangleMesh split = test::sphere(0.5, 3);
  const Triangle first = split.triangles.front();
  const int added = static_cast<int>(split.points.size());
  split.points.push_back(split.points[first[0]]);
  split.triangles.front() = {added, first[1], first[2]};
  split.triangles.push_back({first[0], first[1], added});
  split.triangles.push_back({first[0], added, first[2]});
  EXPECT_TRUE(test::is_closed(split));
  EXPECT_TRUE(intersections(test::sphere(0.501, 3), split).empty());
}

TEST(Intersections, AreThoseOfEveryPairByItself) {
  // Two crumpled sheets cross: hundreds of pairs meet, and thousands do not.
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto crumpled = [&](int subdivisions, const Vec3& middle) {
    TriangleMesh mesh = test::sphere(0.1, subdivisions);
    for (Vec3& p : mesh.points) p += middle + 0.01 * Vec3(unit(random), unit(random), unit(random));
    return mesh;
  };
  const TriangleMesh small = crumpled(2, {0.03, 0.02, 0.01});
  const TriangleMesh large = crumpled(3, {0, 0, 0});
  const auto alone = [](const TriangleMesh& mesh, int triangle) {
    return TriangleMesh{mesh.points, {mesh.triangles[triangle]}};
  };
  std::vector<TrianglePair> expected;
  for (int a = 0; a < static_cast<int>(small.triangles.size()); ++a) {
    const TriangleMesh one = alone(small, a);
    for (int b = 0; b < static_cast<int>(large.triangles.size()); ++b) {
      if (!intersections(one, alone(large, b)).empty()) expected.push_back({a, b});
    }
  }
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(intersections(small, large), expected);
  std::vector<TrianglePair> turned;
  for (const auto& [b, a] : intersections(large, small)) turned.push_back({a, b});
  std::sort(turned.begin(), turned.end());
  EXPECT_EQ(turned, expected);
  std::cout << expected.size() << " pairs\n";
}

}  // namespace intersections_test
}  // namespace toile
