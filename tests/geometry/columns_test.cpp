#include "geometry/columns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace columns_test {

const Vec4s rows = {Vec4{1, 2, 3, 4}, Vec4{-5, 6, 7, 8}, Vec4{9, -10, 11, 12},
                    Vec4{13, 14, -15, 16}, Vec4{0.1, 0.2, 0.3, 0.4}};

TEST(Columns, HoldTheComponentsOfFourVectorsAndGiveThemBack) {
  Vec4 fourth;
  const Columns columns = columns_of(rows[0], rows[1], rows[2], rows[3], &fourth);
  Vec4 back[4];
  store_rows(columns, back, {3, 2, 1, 0});
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(as_vec3(back[3 - i]), as_vec3(rows[i]));
    EXPECT_EQ(back[3 - i][3], 0);
    EXPECT_EQ(fourth[i], rows[i][3]);
  }
}

TEST(Columns, GiveTheSameBitsAsOneVectorAtATime) {
  const Columns columns = columns_of(rows[0], rows[1], rows[2], rows[4]);
  const Vec4 lengths = square_root(dot(columns, columns));
  const int of[4] = {0, 1, 2, 4};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(lengths[i], std::sqrt(squared_length(rows[of[i]])));
}

TEST(Columns, OnlyTheLongOnesAreShortened) {
  const Columns columns = columns_of(rows[0], rows[1], rows[2], rows[4]);
  Vec4 back[4];
  store_rows(shortened(columns, 5), back, {0, 1, 2, 3});
  EXPECT_EQ(as_vec3(back[0]), as_vec3(rows[0]));
  EXPECT_NEAR(std::sqrt(squared_length(back[1])), 5, 1e-14);
  EXPECT_NEAR(std::sqrt(squared_length(back[2])), 5, 1e-14);
  EXPECT_EQ(as_vec3(back[3]), as_vec3(rows[4]));
}

TEST(Places, BeyondTheEndAreTheLastOneAndAreNotSet) {
  std::vector<double> numbers = {0, 1, 2, 3, 4, 5};
  const Vec4 read = Places(4, 6).of(numbers);
  EXPECT_EQ(read[0], 4);
  for (int lane = 1; lane < 4; ++lane) EXPECT_EQ(read[lane], 5);
  Places(4, 6).set(numbers, Vec4{40, 50, 60, 70});
  EXPECT_EQ(numbers, (std::vector<double>{0, 1, 2, 3, 40, 50}));
  Places(1, 5).set(numbers, Vec4{10, 20, 30, 40});
  EXPECT_EQ(numbers, (std::vector<double>{0, 10, 20, 30, 40, 50}));
}

}  // namespace columns_test
}  // namespace toile
