#include "geometry/distance_grid.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include "tests/support/shapes.h"

namespace toile {
namespace {

constexpr double radius = 0.1;

class SphereGrid : public testing::Test {
 protected:
  BodyDistance body{test::sphere(radius, 6)};
  DistanceGrid grid{body};
};

TEST_F(SphereGrid, IsTheDistanceNearTheSkinUpToTheStatedSmoothing) {
  // The B-spline adds cell² / 8 times the sum of the principal curvatures, 2/R on a sphere.
  const double smoothing = 0.005 * 0.005 / 8 * 2 / radius;
  for (int i = 0; i < 500; ++i) {
    const Vec3 direction = Vec3(std::sin(i), std::cos(1.7 * i), std::sin(0.3 * i)).normalized();
    const double off = -0.012 + 0.024 * i / 499;
    const auto sample = grid.at((radius + off) * direction);
    EXPECT_NEAR(sample.distance, off, 1.5 * smoothing);
    EXPECT_GT(sample.gradient.normalized().dot(direction), std::cos(0.02));
    EXPECT_NEAR(sample.gradient.norm(), 1, 0.02);
  }
}

TEST_F(SphereGrid, HasAContinuousGradient) {
  // The jumps of a trilinear gradient are of the order cell/R = 0.05 and stall a solver.
  double largest = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(0.08 + 1e-5 * i, 0.02, 0.03);
    largest =
        std::max(largest, (grid.at(p + Vec3(1e-7, 0, 0)).gradient - grid.at(p).gradient).norm());
  }
  EXPECT_LT(largest, 1e-4);
}

TEST_F(SphereGrid, TellsInsideFromOutsideEverywhere) {
  EXPECT_LT(grid.at({0, 0, 0}).distance, -0.05);
  EXPECT_GT(grid.at({0.13, 0, 0}).distance, 0.02);
  EXPECT_GT(grid.at({9, 9, 9}).distance, 0.02);
  EXPECT_GT(grid.at({std::nan(""), 0, 0}).distance, 0.02);
}

TEST_F(SphereGrid, HasTheSameBitsForAnyNumberOfThreads) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const DistanceGrid alone(body);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p(0.1 * std::sin(i), 0.1 * std::cos(2.0 * i), 0.1 * std::sin(3.0 * i));
    EXPECT_EQ(alone.at(p).distance, grid.at(p).distance);
  }
}

}  // namespace
}  // namespace toile
