#include "cloth/contact/edge_face_intersections.h"

#include <gtest/gtest.h>

#include "geometry/intersections.h"

namespace toile {
namespace edge_face_intersections_test {

/// A large triangle in the plane z = 0, and a small one, square to it, whose tip `below` lies under
/// it.
std::vector<Vec3> tip(double below) {
  return {{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}, {-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0, 0.01, -below}};
}
const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 4, 5}};

TEST(EdgeFaceIntersections, CleanClothHasNone) {
  EXPECT_TRUE(find_edge_face_intersections(tip(-0.05), triangles).empty());
}

TEST(EdgeFaceIntersections, TheEdgesThatPassAFaceAreFoundWithTheirPlaces) {
  const std::vector<Vec3> x = tip(0.05);
  const std::vector<EdgeFaceIntersection> found = find_edge_face_intersections(x, triangles);
  ASSERT_EQ(found.size(), 2U);
  for (const EdgeFaceIntersection& crossing : found) {
    Vec3 on_edge = Vec3::Zero();
    for (int i = 0; i < 2; ++i) on_edge += crossing.weights[i] * x[crossing.edge[i]];
    Vec3 on_face = Vec3::Zero();
    for (int i = 0; i < 3; ++i) on_face += crossing.weights[2 + i] * x[crossing.face[i]];
    EXPECT_LT((on_edge - on_face).norm(), 1e-12);
  }
}

/// Length of the line along which the two triangles of tip() intersect.
double line(const std::vector<EdgeFaceIntersection>& found, const std::vector<Vec3>& x) {
  std::vector<Vec3> ends;
  for (const EdgeFaceIntersection& crossing : found) {
    ends.push_back(crossing.weights[0] * x[crossing.edge[0]] +
                   crossing.weights[1] * x[crossing.edge[1]]);
  }
  return (ends.at(1) - ends.at(0)).norm();
}

TEST(EdgeFaceIntersections, TheWayIsTheNegativeGradientOfTheLine) {
  std::vector<Vec3> x = tip(0.05);
  const std::vector<EdgeFaceIntersection> found = find_edge_face_intersections(x, triangles);
  ASSERT_EQ(found.size(), 2U);
  // All of the small triangle moves: the ways of its edges add up.
  const Vec3 sum = found[0].way + found[1].way;
  const double step = 1e-6;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Vec3> up = x, down = x;
    for (int v = 3; v < 6; ++v) {
      up[v][axis] += step;
      down[v][axis] -= step;
    }
    const double slope = (line(find_edge_face_intersections(up, triangles), up) -
                          line(find_edge_face_intersections(down, triangles), down)) /
                         (2 * step);
    EXPECT_NEAR(sum[axis], -slope, 1e-6) << axis;
  }
}

TEST(EdgeFaceIntersections, ATipThatCameThroughIsDrawnBack) {
  std::vector<Vec3> x = tip(0.05);
  int steps = 0;
  for (; steps < 200 && !self_intersections({x, triangles}).empty(); ++steps) {
    for (const EdgeFaceIntersection& crossing : find_edge_face_intersections(x, triangles)) {
      for (int i = 0; i < 2; ++i) x[crossing.edge[i]] += 0.002 * crossing.way;
    }
  }
  EXPECT_LT(steps, 200);
  EXPECT_GT(x[5].z(), -1e-9);
  EXPECT_LT(x[5].z(), 0.02);  // no farther than it needs
}

}  // namespace edge_face_intersections_test
}  // namespace toile
