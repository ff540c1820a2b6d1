#include "geometry/node_values.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace toile {

TEST(NodeValues, KeepsANumberForEachNode) {
  const NodeValues::Index first = {-3, 2, -1};
  NodeValues values(first, {4, 3, 5});
  ASSERT_EQ(values.count(), 60U);
  std::set<std::size_t> places;
  for (int k = 0; k < 5; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 4; ++i) {
        const std::size_t place = values.place({first[0] + i, first[1] + j, first[2] + k});
        EXPECT_LT(place, values.count());
        places.insert(place);
        EXPECT_EQ(values.load(place), 0);
        EXPECT_EQ(values.store(place, 1.5F), 0);
        EXPECT_EQ(values.store(place, 0.5F), 1.5F);
        EXPECT_EQ(values.load(place), 0.5F);
      }
    }
  }
  EXPECT_EQ(places.size(), values.count());
  // Neighbours along x are read together, the last ones with what lies beyond.
  EXPECT_EQ(values.place({-2, 2, -1}), values.place(first) + 1);
  EXPECT_EQ(values.data()[values.count() + 2], 0);
  const NodeValues moved = std::move(values);
  EXPECT_EQ(moved.load(moved.place(first)), 0.5F);
}

}  // namespace toile
