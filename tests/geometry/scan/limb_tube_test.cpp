#include "geometry/scan/limb_tube.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace toile {
namespace limb_tube_test {

constexpr double radius = 0.08;

/// Samples of an upright cylinder about z, 30 cm long, where `is_seen` at an angle and a height.
template <class Seen>
ScanSamples cylinder(const Seen& is_seen) {
  ScanSamples samples;
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k <= 60; ++k) {
      const double angle = 2 * std::numbers::pi * i / 100;
      const double height = 0.005 * k;
      if (!is_seen(angle, height)) continue;
      const Vec3 out(std::cos(angle), std::sin(angle), 0);
      samples.points.push_back(radius * out + Vec3(0, 0, height));
      samples.normals.push_back(out);
      samples.areas.push_back(0.005 * 0.005);
    }
  }
  return samples;
}

/// About an axis that is 1 cm off the middle.
LimbTube tube_of(const ScanSamples& samples) {
  std::vector<int> all(samples.points.size());
  std::iota(all.begin(), all.end(), 0);
  return {{.start = {0.01, 0, 0}, .along = {0, 0, 1}, .length = 0.3, .toward = {1, 0, 0}},
          samples,
          all,
          {}};
}

TEST(LimbTube, GoesOnAsAnArcWhereNothingWasSeen) {
  // A quarter of it, from a third of the height on.
  const LimbTube tube = tube_of(cylinder([](double angle, double height) {
    return height < 0.1 || (angle > 0.8 && angle < 2 * std::numbers::pi - 0.8);
  }));
  EXPECT_LT(tube.error(), 1e-4);
  for (double height = 0.01; height < 0.3; height += 0.02) {
    EXPECT_NEAR(tube.off({radius, 0, height}), 0, 1e-3) << height;
    EXPECT_NEAR(tube.off({radius + 0.02, 0, height}), 0.02, 1e-3);
    EXPECT_NEAR(tube.off({-radius + 0.02, 0, height}), -0.02, 1e-3);
  }
  EXPECT_NEAR(tube.facing({0.06, 0, 0.2}), 1, 1e-12);
  EXPECT_NEAR(tube.facing({0.01, 0.05, 0.2}), 0, 1e-12);
}

TEST(LimbTube, LeavesOutWhatIsBehindAndWhatFacesTheAxis) {
  ScanSamples samples = cylinder([](double, double) { return true; });
  const std::size_t own = samples.points.size();
  for (std::size_t i = 0; i < own; ++i) {
    if (samples.normals[i].x() < 0.9) continue;
    // A hand's far side, and its near one.
    samples.points.emplace_back(samples.points[i] + 0.06 * samples.normals[i]);
    samples.normals.push_back(samples.normals[i]);
    samples.points.emplace_back(samples.points[i] + 0.02 * samples.normals[i]);
    samples.normals.emplace_back(-samples.normals[i]);
  }
  samples.areas.resize(samples.points.size(), 0.005 * 0.005);
  const LimbTube tube = tube_of(samples);
  EXPECT_NEAR(tube.off({radius, 0, 0.15}), 0, 1e-3);
}

TEST(LimbTube, WithoutSamplesItsErrorIsInfinite) { EXPECT_TRUE(std::isinf(tube_of({}).error())); }

}  // namespace limb_tube_test
}  // namespace toile
