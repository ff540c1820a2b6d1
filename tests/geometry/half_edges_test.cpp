#include "geometry/half_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/support/shapes.h"

namespace toile {
namespace half_edges_test {

TEST(HalfEdges, EverySideOnceByEdgeThenByTriangle) {
  const TriangleMesh mesh = test::sphere(0.1, 2);
  const std::vector<HalfEdge> sides = half_edges(mesh.triangles, mesh.points.size());
  ASSERT_EQ(sides.size(), 3 * mesh.triangles.size());
  const auto key = [](const HalfEdge& s) {
    return std::tuple(s.low, s.high, s.triangle, s.opposite);
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const HalfEdge& side = sides[i];
    const Triangle& corners = mesh.triangles[side.triangle];
    const int from = corners[(side.opposite + 1) % 3];
    const int to = corners[(side.opposite + 2) % 3];
    EXPECT_EQ(side.low, std::min(from, to));
    EXPECT_EQ(side.high, std::max(from, to));
    EXPECT_EQ(side.forward, from < to);
    if (i > 0) {
      EXPECT_LT(key(sides[i - 1]), key(side));
    }
    // Each edge of a closed surface has two sides that run in opposite directions.
    if (i % 2 == 1) {
      EXPECT_TRUE(side.same_edge(sides[i - 1]));
      EXPECT_NE(side.forward, sides[i - 1].forward);
    }
  }
}

TEST(HalfEdges, OfNothingThereAreNone) { EXPECT_TRUE(half_edges({}, 7).empty()); }

TEST(HalfEdges, UniqueEdgesAreTheSidesWithoutRepeats) {
  const TriangleMesh mesh = test::sphere(0.1, 2);
  const std::vector<std::array<int, 2>> edges = unique_edges(mesh.triangles);
  const std::vector<HalfEdge> sides = half_edges(mesh.triangles, mesh.points.size());
  ASSERT_EQ(2 * edges.size(), sides.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    EXPECT_EQ(edges[e][0], sides[2 * e].low);
    EXPECT_EQ(edges[e][1], sides[2 * e].high);
  }
}

}  // namespace half_edges_test
}  // namespace toile
