#include "geometry/scan/unseen.h"

#include <gtest/gtest.h>

namespace toile {
namespace unseen_test {

/// A wall of samples 7 mm apart at z = 0, 20 cm wide, without those within 5 cm of the origin.
std::vector<Vec3> wall_with_hole() {
  std::vector<Vec3> samples;
  for (int i = -14; i <= 14; ++i) {
    for (int k = -14; k <= 14; ++k) {
      const Vec3 p(0.007 * i, 0.007 * k, 0);
      if (p.norm() > 0.05) samples.push_back(p);
    }
  }
  return samples;
}

TEST(Unseen, IsNoneOnSamplesAndAllBeyondReach) {
  const Unseen unseen(wall_with_hole(), 0.0175);
  EXPECT_EQ(unseen({0.08, 0, 0}), 0);
  EXPECT_EQ(unseen({0.0765, 0.0035, 0.003}), 0);
  EXPECT_EQ(unseen({0, 0, 0}), 1);
  EXPECT_EQ(unseen({0.08, 0, 0.03}), 1);
  EXPECT_EQ(unseen({5, 5, 5}), 1);
  EXPECT_FALSE(unseen.is_far({0.0765, 0.0035, 0.003}));
  EXPECT_TRUE(unseen.is_far({0, 0, 0}));
}

TEST(Unseen, RisesIntoTheHole) {
  const Unseen unseen(wall_with_hole(), 0.0175);
  double before = 0;
  for (double x = 0.06; x > 0.02; x -= 0.002) {
    const double now = unseen({x, 0, 0});
    EXPECT_GE(now, before - 1e-12) << x;
    before = now;
  }
  EXPECT_EQ(before, 1);
}

}  // namespace unseen_test
}  // namespace toile
