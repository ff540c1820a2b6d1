#include "geometry/distance_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <thread>

#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace distance_grid_test {

constexpr double radius = 0.1;

class BoxGrid : public testing::Test {
 protected:
  SurfaceDistance body{test::sphere(radius, 6)};
  DistanceGrid grid{body};
};

TEST_F(BoxGrid, IsTheDistanceNearTheSkinUpToTheStatedSmoothing) {
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

TEST_F(BoxGrid, HasAContinuousGradient) {
  // The jumps of a trilinear gradient are of the order cell/R = 0.05 and stall a solver.
  double largest = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(0.08 + 1e-5 * i, 0.02, 0.03);
    largest =
        std::max(largest, (grid.at(p + Vec3(1e-7, 0, 0)).gradient - grid.at(p).gradient).norm());
  }
  EXPECT_LT(largest, 1e-4);
}

TEST_F(BoxGrid, TellsInsideFromOutsideEverywhere) {
  EXPECT_LT(grid.at({0, 0, 0}).distance, -0.05);
  EXPECT_GT(grid.at({0.13, 0, 0}).distance, 0.02);
  EXPECT_GT(grid.at({9, 9, 9}).distance, 0.02);
  EXPECT_GT(grid.at({std::nan(""), 0, 0}).distance, 0.02);
}

/// Points in and around a box about the shape, more of them near it than far.
std::vector<Vec3> scattered(const TriangleMesh& mesh, int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const Vec3& at = mesh.points[random() % mesh.points.size()];
    const double off = std::array{0.01, 0.05, 0.3}[static_cast<std::size_t>(i) % 3];
    points.push_back(at + off * Vec3(unit(random), unit(random), unit(random)));
  }
  return points;
}

TEST_F(BoxGrid, RemembersWhatAnotherKnew) {
  const std::vector<Vec3> points = scattered(body.mesh(), 2000);
  for (const Vec3& p : points) grid.at(p);
  const DistanceCache cache = grid.cache();
  EXPECT_GT(grid.computed_nodes(), 1000U);
  DistanceGrid again{body};
  ASSERT_TRUE(again.restore(cache));
  for (const Vec3& p : points) {
    const auto before = grid.at(p);
    const auto after = again.at(p);
    ASSERT_EQ(after.distance, before.distance);
    ASSERT_EQ(after.gradient, before.gradient);
  }
  EXPECT_EQ(again.computed_nodes(), 0U);
  // Lookups elsewhere still compute nodes.
  for (const Vec3& p : scattered(body.mesh(), 4000)) {
    ASSERT_EQ(again.at(p).distance, grid.at(p).distance);
  }
  EXPECT_GT(again.computed_nodes(), 0U);
}

TEST_F(BoxGrid, TakesNothingFromAnotherSurfacesGrid) {
  grid.at({radius, 0, 0});
  DistanceCache cache = grid.cache();
  DistanceGridOptions options;
  options.cell = 0.004;
  EXPECT_FALSE(DistanceGrid(body, options).restore(cache));
  options = {};
  options.band = 0.02;
  EXPECT_FALSE(DistanceGrid(body, options).restore(cache));
  EXPECT_FALSE(DistanceGrid(SurfaceDistance(test::sphere(2 * radius, 6))).restore(cache));
  for (const int number : {-1, 1 << 30}) {
    cache.levels[1].push_back({number, {}});
    DistanceGrid fresh{body};
    EXPECT_FALSE(fresh.restore(cache));
    fresh.at({radius, 0, 0});
    EXPECT_GT(fresh.computed_nodes(), 0U);
    cache.levels[1].pop_back();
  }
}

TEST_F(BoxGrid, HasTheSameBitsForAnyThreadsAndOrderOfAsking) {
  const std::vector<Vec3> points = scattered(body.mesh(), 3000);
  const DistanceGrid backward(body);
  for (std::size_t i = points.size(); i-- > 0;) backward.at(points[i]);
  // Four threads look up the same blocks at once.
  const DistanceGrid crowded(body);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (const Vec3& p : points) crowded.at(p);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Vec3& p : points) {
    const auto expected = grid.at(p);
    for (const DistanceGrid* other : {&backward, &crowded}) {
      EXPECT_EQ(other->at(p).distance, expected.distance);
      EXPECT_EQ(other->at(p).gradient, expected.gradient);
    }
  }
}

TEST_F(BoxGrid, NeverSaysMoreThanAtLeastAllows) {
  double largest = 0;
  for (const Vec3& p : scattered(body.mesh(), 3000)) {
    const double said = grid.at(p).distance;
    const double exact = body.closest_point(p).distance;
    // The bound may miss by the spline's smoothing. Nothing needs the clearance deep inside.
    if (exact > -0.02) {
      EXPECT_LT(grid.lower_bound(said), exact + 1e-4);
    }
    if (std::abs(exact) > 0.002) {
      EXPECT_EQ(said < 0, exact < 0);
    }
    if (std::abs(exact) < 0.04) largest = std::max(largest, std::abs(said - exact));
  }
  std::cout << "within " << 1000 * largest << " mm up to 40 mm off\n";
  EXPECT_LT(largest, 0.002);
}

TEST(DistanceGrid, IsExactOnEveryFeatureAtItsNodes) {
  // At a box's edges and corners, concave ones included, the grid equals the spline through exact
  // values at the nodes.
  const SurfaceDistance body(test::box({-0.04, 0, -0.03}, {0.05, 0.3, 0.04}));
  const DistanceGridOptions options;
  const DistanceGrid grid(body, options);
  const Vec3 origin = Vec3(-0.04, 0, -0.03) - Vec3::Constant(options.padding + options.cell);
  double largest = 0;
  for (const Vec3& p : scattered(body.mesh(), 600)) {
    double spline = 0;
    bool near = true;
    const Vec3 local = (p - origin) / options.cell;
    Vec3 weights[3];
    Vec3 centre;
    for (int axis = 0; axis < 3; ++axis) {
      centre[axis] = std::floor(local[axis] + 0.5);
      const double t = local[axis] - centre[axis];
      weights[axis] = {0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)};
    }
    for (int n = 0; n < 27; ++n) {
      const Vec3 node = centre + Vec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const double exact = body.closest_point(origin + options.cell * node).distance;
      near = near && std::abs(exact) < options.band;
      spline += weights[0][n % 3] * weights[1][n / 3 % 3] * weights[2][n / 9] * exact;
    }
    if (near) largest = std::max(largest, std::abs(grid.at(p).distance - spline));
  }
  std::cout << "within " << largest << " m of the exact spline\n";
  EXPECT_LT(largest, 1e-9);
}

/// A cylinder of 12 cm that wears a sheet `off` metres from its skin, from y = 0.12 to 0.24.
class WornSheet : public testing::Test {
 protected:
  void wear(double off) {
    const DressedGarment cloth = test::cloth_tube(0.06 + off, 0.06 + off, 0.12, 0.24, 160, 12);
    sheet.emplace(TriangleMesh{cloth.points, cloth.triangles});
    grid.emplace(std::vector{body, *sheet});
  }
  double at(double r, double y, double angle = 0.3) const {
    return grid->at({r * std::sin(angle), y, r * std::cos(angle)}).distance;
  }

  SurfaceDistance body{test::closed_tube(0.06, 0.06, 0.3, 160)};
  std::optional<SurfaceDistance> sheet;
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
    // The tolerance is cell²/(8 R) and the sagitta of the sheet's chords.
    EXPECT_LT(largest, 8e-5) << off;
    // Between skin and sheet, also in the middle, the gradient points out through the sheet.
    const auto between = grid->at({0, 0.18, 0.06 + 0.5 * off});
    EXPECT_LT(between.distance, 0);
    EXPECT_GT(between.gradient.normalized().z(), 0.99);
    EXPECT_LT(at(0.02, 0.18), -0.03) << "inside the body";
    // Far beyond the hem the body is closest.
    EXPECT_NEAR(at(0.065, 0.06), 0.005, 8e-5);
    EXPECT_NEAR(at(0.057, 0.06), -0.003, 8e-5);
  }
}

TEST_F(WornSheet, AddedToAGridThatWasAskedItIsAsIfItHadBeenThereFirst) {
  // The sheet is wider than the grid of the body alone.
  for (const double off : {0.002, 0.1}) {
    wear(off);
    std::vector<Vec3> points = scattered(body.mesh(), 1000);
    const std::vector<Vec3> more = scattered(sheet->mesh(), 1000);
    points.insert(points.end(), more.begin(), more.end());
    DistanceGrid grown(body);
    for (const Vec3& p : points) grown.at(p);
    grown.add(*sheet);
    for (const Vec3& p : points) {
      EXPECT_EQ(grown.at(p).distance, grid->at(p).distance);
      EXPECT_EQ(grown.at(p).gradient, grid->at(p).gradient);
    }
  }
}

TEST_F(WornSheet, TheHemIsASmallStep) {
  wear(0.002);
  // The points follow cloth that slides down, 2 mm off the sheet and past its hem.
  double least = 1, largest_jump = 0, last = at(0.064, 0.16);
  for (double y = 0.16; y > 0.06; y -= 1e-4) {
    const double here = at(0.064, y);
    largest_jump = std::max(largest_jump, std::abs(here - last));
    least = std::min(least, here);
    last = here;
  }
  RecordProperty("min_mm", std::to_string(1000 * least));
  EXPECT_GT(least, 0.0017);
  EXPECT_NEAR(last, 0.004, 8e-5);
  EXPECT_LT(largest_jump, 1e-4) << "as far as the point moved";
}

}  // namespace distance_grid_test
}  // namespace toile
