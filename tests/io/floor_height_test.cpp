#include "io/floor_height.h"

#include <gtest/gtest.h>

namespace toile {
namespace floor_height_test {

TEST(FloorHeight, IsAboveOrBelow) {
  EXPECT_EQ(floor_height(0.4), "40 cm above the floor");
  EXPECT_EQ(floor_height(-0.4), "40 cm below the floor");
  EXPECT_EQ(floor_height(-0.004), "0 cm above the floor");
  EXPECT_EQ(floor_height(-0.004, 1), "0.4 cm below the floor");
}

TEST(FloorHeight, OfARangeNamesEachSide) {
  EXPECT_EQ(floor_heights(0.05, 0.12), "5 to 12 cm above the floor");
  EXPECT_EQ(floor_heights(-0.12, -0.05), "12 to 5 cm below the floor");
  EXPECT_EQ(floor_heights(-0.12, 0.05), "12 cm below the floor to 5 cm above the floor");
}

}  // namespace floor_height_test
}  // namespace toile
