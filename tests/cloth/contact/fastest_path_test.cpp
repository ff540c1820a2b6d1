#include "cloth/contact/fastest_path.h"

#include <gtest/gtest.h>

#include <vector>

namespace toile {
namespace fastest_path_test {

TEST(FastestPath, AddsUpTheLargestMoves) {
  std::vector<Vec3> x(10000, Vec3::Zero());
  FastestPath path;
  path.follow(as_vec4(x));
  EXPECT_EQ(path.length(), 0);
  x[9999].y() += 0.25;
  x[1].x() += 0.125;
  path.follow(as_vec4(x));
  EXPECT_DOUBLE_EQ(path.length(), 0.25);
  // It goes back: its path grows all the same.
  x[9999].y() -= 0.5;
  path.follow(as_vec4(x));
  EXPECT_DOUBLE_EQ(path.length(), 0.75);
  path.follow(as_vec4(x));
  EXPECT_DOUBLE_EQ(path.length(), 0.75);
}

}  // namespace fastest_path_test
}  // namespace toile
