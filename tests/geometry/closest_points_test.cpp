#include "geometry/closest_points.h"

#include <gtest/gtest.h>

#include <random>

namespace toile {
namespace closest_points_test {

TEST(Nearest, OfASegmentIsBesideThePointOrAnEnd) {
  EXPECT_EQ(closest_on_segment(Vec2(1, 5), Vec2(0, 0), Vec2(4, 0)), 0.25);
  EXPECT_EQ(closest_on_segment(Vec3(-1, 2, 3), Vec3(0, 0, 0), Vec3(4, 0, 0)), 0);
  EXPECT_EQ(closest_on_segment(Vec3(9, 2, 3), Vec3(0, 0, 0), Vec3(4, 0, 0)), 1);
  EXPECT_EQ(closest_on_segment(Vec2(9, 2), Vec2(1, 1), Vec2(1, 1)), 0);
}

TEST(Nearest, BeatsEverySampleOfTheTriangle) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 p = point(), a = point(), b = point(), c = point();
    const Vec3 w = closest_on_triangle(p, a, b, c);
    EXPECT_NEAR(w.sum(), 1, 1e-12);
    EXPECT_GE(w.minCoeff(), 0);
    const double best = (w[0] * a + w[1] * b + w[2] * c - p).norm();
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; i + j <= 20; ++j) {
        const double u = i / 20.0, v = j / 20.0;
        EXPECT_LE(best, (u * a + v * b + (1 - u - v) * c - p).norm() + 1e-12);
      }
    }
  }
}

TEST(Nearest, BeatsEverySampleOfTheSegments) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  for (int trial = 0; trial < 400; ++trial) {
    const Vec3 a = point(), b = point(), c = point();
    // Every fourth pair is parallel, where the general formula divides by zero.
    const Vec3 d = trial % 4 == 0 ? Vec3(c + 0.7 * (b - a)) : point();
    const auto [s, t] = closest_on_segments(a, b, c, d);
    const double best = (a + s * (b - a) - c - t * (d - c)).norm();
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 20; ++j) {
        EXPECT_LE(best, (a + i / 20.0 * (b - a) - c - j / 20.0 * (d - c)).norm() + 1e-12);
      }
    }
  }
}

}  // namespace closest_points_test
}  // namespace toile
