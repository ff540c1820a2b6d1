#include "geometry/slice.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/shapes.h"

namespace toile {
namespace slice_test {

using test::box;
using test::sphere;

TEST(Slice, BoxGivesItsRectangle) {
  const auto sections = slice(box({-1, 0, -2}, {1, 3, 2}), {0, 1.25, 0}, {0, 2, 0});
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_TRUE(sections[0].closed);
  EXPECT_NEAR(sections[0].length, 12, 1e-12);
  EXPECT_NEAR(sections[0].girth, 12, 1e-12);
  EXPECT_NEAR(sections[0].area, 8, 1e-12);
  EXPECT_LT((sections[0].centroid - Vec3(0, 1.25, 0)).norm(), 1e-12);
}

TEST(Slice, SaysWhichTrianglesAreCutInOrder) {
  const TriangleMesh mesh = box({-1, 0, -2}, {1, 3, 2});
  const Section section = slice(mesh, {0, 1.25, 0}, {0, 1, 0}).front();
  ASSERT_EQ(section.triangles.size(), 8U);  // two on each of the four sides
  ASSERT_EQ(section.points.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(section.triangles[i])];
    const Vec3 normal = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    for (const Vec3& end : {section.points[i], section.points[(i + 1) % 8]}) {
      EXPECT_NEAR(normal.dot(end - mesh.points[a]), 0, 1e-12);
    }
  }
}

TEST(Slice, PlaneThroughVerticesStillGivesOneClosedLoop) {
  // The octahedron's equator lies in the plane, split edges and all.
  const auto sections = slice(sphere(0.5, 5), {0, 0, 0}, {0, 1, 0});
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_TRUE(sections[0].closed);
  EXPECT_EQ(sections[0].points.size(), 128u);
  EXPECT_NEAR(sections[0].girth, 2 * std::numbers::pi * 0.5, 1e-3);
  EXPECT_NEAR(sections[0].area, std::numbers::pi * 0.25, 1e-3);
}

TEST(Slice, ObliqueSectionOfASphereIsACircle) {
  const Vec3 normal = Vec3(1, 1, 1).normalized();
  const auto sections = slice(sphere(1, 6), 0.6 * normal, normal);
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_NEAR(sections[0].girth, 2 * std::numbers::pi * 0.8, 5e-3);
  EXPECT_LT((sections[0].centroid - 0.6 * normal).norm(), 1e-3);
}

TEST(Slice, GirthBridgesHollowsAsATapeDoes) {
  // A tape around two legs follows the hull of both sections.
  TriangleMesh u = box({0, 0, 0}, {3, 1, 1});
  const auto sections = slice(test::together(u, box({5, 0, 0}, {6, 1, 1})), {0, 0.5, 0}, {0, 1, 0});
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_NEAR(sections[0].area, 3, 1e-12);
  EXPECT_NEAR(sections[1].area, 1, 1e-12);
  std::vector<Vec3> both = sections[0].points;
  both.insert(both.end(), sections[1].points.begin(), sections[1].points.end());
  EXPECT_NEAR(hull_length(both, {0, 1, 0}), 14, 1e-12);
}

TEST(Slice, CavityHasNegativeArea) {
  const TriangleMesh hollow =
      test::together(box({0, 0, 0}, {4, 4, 4}), test::inside_out(box({1, 1, 1}, {2, 2, 2})));
  const auto sections = slice(hollow, {0, 1.5, 0}, {0, 1, 0});
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_NEAR(sections[0].area, 16, 1e-12);
  EXPECT_NEAR(sections[1].area, -1, 1e-12);
}

TEST(Slice, OpenSurfaceGivesAnOpenLine) {
  TriangleMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);  // the face at z = 0
  const auto sections = slice(open, {0, 0.5, 0}, {0, 1, 0});
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_FALSE(sections[0].closed);
  EXPECT_NEAR(sections[0].length, 3, 1e-12);
  EXPECT_EQ(sections[0].area, 0);
}

TEST(Slice, MissingThePlaneIsNothing) {
  EXPECT_TRUE(slice(box({0, 0, 0}, {1, 1, 1}), {0, 5, 0}, {0, 1, 0}).empty());
  // The top lies in the plane and counts as above it: its border is cut.
  EXPECT_EQ(slice(box({0, 0, 0}, {1, 1, 1}), {0, 1, 0}, {0, 1, 0}).size(), 1u);
}

}  // namespace slice_test
}  // namespace toile
