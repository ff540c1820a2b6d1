#include "geometry/disjoint_sets.h"

#include <gtest/gtest.h>

namespace toile {
namespace disjoint_sets_test {

TEST(DisjointSets, ASetIsNamedByItsLowestItem) {
  DisjointSets sets(6);
  sets.join(5, 4);
  sets.join(2, 5);
  EXPECT_EQ(sets.of(4), 2);
  EXPECT_EQ(sets.of(5), 2);
  EXPECT_EQ(sets.of(3), 3);
  sets.join(0, 3);
  sets.join(4, 3);
  for (const int item : {0, 2, 3, 4, 5}) EXPECT_EQ(sets.of(item), 0) << item;
  EXPECT_EQ(sets.of(1), 1);
}

TEST(DisjointSets, ALongChainStaysCheap) {
  constexpr int count = 1000000;
  DisjointSets sets(count);
  for (int i = count - 1; i > 0; --i) sets.join(i, i - 1);
  for (int i = 0; i < count; ++i) ASSERT_EQ(sets.of(i), 0);
  for (int i = 0; i < count; ++i) ASSERT_EQ(sets.of(count - 1), 0);
}

}  // namespace disjoint_sets_test
}  // namespace toile
