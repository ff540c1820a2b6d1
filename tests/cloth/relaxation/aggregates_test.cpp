#include "cloth/relaxation/aggregates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cloth/panels.h"

namespace toile {
namespace aggregates_test {

TEST(Aggregates, CoverASheetAndAreAFewEdgesAcross) {
  const PlanarMesh sheet = test::grid(1, 1, 20, 20);
  const Aggregates aggregates = aggregate(neighbours_of(sheet.triangles, sheet.points.size()));
  EXPECT_GT(aggregates.middles.size(), sheet.points.size() / 7);
  EXPECT_LT(aggregates.middles.size(), sheet.points.size() / 3);
  ASSERT_EQ(aggregates.of_vertices.size(), sheet.points.size());
  const double edge = std::sqrt(2) / 20;  // the length of the longest edges
  for (std::size_t v = 0; v < sheet.points.size(); ++v) {
    double sum = 0;
    for (const auto& [aggregate, weight] : aggregates.of_vertices[v]) {
      EXPECT_GT(weight, 0);
      EXPECT_LT((sheet.points[aggregates.middles[aggregate]] - sheet.points[v]).norm(),
                2.001 * edge);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(Aggregates, OfAggregatesAreWider) {
  const PlanarMesh sheet = test::grid(1, 1, 20, 20);
  const Aggregates aggregates = aggregate(neighbours_of(sheet.triangles, sheet.points.size()));
  const Aggregates wider = aggregate(aggregates.neighbours);
  EXPECT_LT(3 * wider.middles.size(), aggregates.middles.size());
  for (std::size_t p = 0; p < aggregates.neighbours.size(); ++p) {
    EXPECT_FALSE(aggregates.neighbours[p].empty());
    for (const int other : aggregates.neighbours[p]) {
      const std::vector<int>& back = aggregates.neighbours[other];
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), static_cast<int>(p)));
    }
  }
}

TEST(Aggregates, AVertexWithoutNeighboursIsAnAggregate) {
  const Aggregates aggregates = aggregate(neighbours_of({{0, 1, 2}}, 4));
  ASSERT_EQ(aggregates.middles.size(), 2U);
  ASSERT_EQ(aggregates.of_vertices[3].size(), 1U);
  EXPECT_EQ(aggregates.of_vertices[3][0].aggregate, 1);
  EXPECT_EQ(aggregates.of_vertices[3][0].weight, 1);
}

}  // namespace aggregates_test
}  // namespace toile
