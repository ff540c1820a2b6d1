#include "geometry/distance_grid.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <optional>

#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

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

/// A cylinder of 12 cm that wears a sheet `off` metres from its skin, from y = 0.12 to 0.24.
class WornSheet : public testing::Test {
 protected:
  void wear(double off) {
    const DressedGarment cloth = test::cloth_tube(0.06 + off, 0.06 + off, 0.12, 0.24, 160, 12);
    sheet.emplace(TriangleMesh{cloth.points, cloth.triangles});
    grid.emplace(std::vector<const BodyDistance*>{&body, &*sheet});
  }
  double at(double r, double y, double angle = 0.3) const {
    return grid->at({r * std::sin(angle), y, r * std::cos(angle)}).distance;
  }

  BodyDistance body{test::closed_tube(0.06, 0.06, 0.3, 160)};
  std::optional<BodyDistance> sheet;
  std::optional<DistanceGrid> grid;
};

TEST_F(WornSheet, TheBodyWithASheetIsABodyAsLargeAsTheSheet) {
  for (const double off : {0.002, 0.01, 0.03}) {
    wear(off);
    double largest = 0;
    for (int i = 0; i <= 100; ++i) {
      const double from_sheet = -0.008 + 0.016 * i / 100;
      const double said = at(0.06 + off + from_sheet, 0.18, 0.1 * i);
      largest = std::max(largest, std::abs(said - from_sheet));
    }
    RecordProperty("error_mm_at_" + std::to_string(1000 * off), std::to_string(1000 * largest));
    // cell²/(8 R), and the chords of the sheet.
    EXPECT_LT(largest, 8e-5) << off;
    // Between skin and sheet, also in the middle, the way out is through the sheet.
    const auto between = grid->at({0, 0.18, 0.06 + 0.5 * off});
    EXPECT_LT(between.distance, 0);
    EXPECT_GT(between.gradient.normalized().z(), 0.99);
    EXPECT_LT(at(0.02, 0.18), -0.03) << "inside the body";
    // Far beyond the hem, the body.
    EXPECT_NEAR(at(0.065, 0.06), 0.005, 8e-5);
    EXPECT_NEAR(at(0.057, 0.06), -0.003, 8e-5);
  }
}

TEST_F(WornSheet, TheHemIsASmallStep) {
  wear(0.002);
  // Along the way that cloth slides down, 2 mm off the sheet and on past its hem.
  double least = 1, largest_jump = 0, last = at(0.064, 0.16);
  for (double y = 0.16; y > 0.06; y -= 1e-4) {
    const double here = at(0.064, y);
    largest_jump = std::max(largest_jump, std::abs(here - last));
    least = std::min(least, here);
    last = here;
  }
  RecordProperty("least_mm", std::to_string(1000 * least));
  EXPECT_GT(least, 0.0017);
  EXPECT_NEAR(last, 0.004, 8e-5);
  EXPECT_LT(largest_jump, 1e-4) << "as far as the point moved";
}

}  // namespace
}  // namespace toile
