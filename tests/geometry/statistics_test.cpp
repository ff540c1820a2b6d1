#include "geometry/statistics.h"

#include <gtest/gtest.h>

namespace toile {
namespace statistics_test {

TEST(Statistics, TheMedianOfAnEvenNumberIsTheUpperOfTheMiddleTwo) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 3);
  EXPECT_EQ(median({}), 0);
}

TEST(Statistics, APercentileIsOneOfTheValues) {
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 0), 1);
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 0.74), 3);
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 0.75), 4);
  EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 1), 5);
  EXPECT_EQ(percentile({}, 0.5), 0);
}

TEST(Statistics, TheRootMeanSquareOfThreeAndFour) {
  EXPECT_DOUBLE_EQ(root_mean_square({3, -4}), std::sqrt(12.5));
}

}  // namespace statistics_test
}  // namespace toile
