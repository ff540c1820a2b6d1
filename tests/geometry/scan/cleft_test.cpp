#include "geometry/scan/cleft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace toile {
namespace cleft_test {

/// A tube about an axis, of radius 8 cm, 30 cm long.
LimbTube tube(const Vec3& start, const Vec3& along, const Vec3& toward) {
  const Vec3 across = along.cross(toward);
  ScanSamples samples;
  for (int i = 0; i < 100; ++i) {
    for (int k = 0; k <= 60; ++k) {
      const double angle = 2 * std::numbers::pi * i / 100;
      const Vec3 out = std::cos(angle) * toward + std::sin(angle) * across;
      samples.points.emplace_back(start + 0.005 * k * along + 0.08 * out);
      samples.normals.push_back(out);
      samples.areas.push_back(0.005 * 0.005);
    }
  }
  std::vector<int> all(samples.points.size());
  std::iota(all.begin(), all.end(), 0);
  return {{.start = start, .along = along, .length = 0.3, .toward = toward}, samples, all, {}};
}

/// Two upright legs, 2 cm apart, under a roof at y = 0.22.
Cleft legs(const CleftOptions& options) {
  return {tube({-0.09, 0, 0}, Vec3::UnitY(), Vec3::UnitX()),
          tube({0.09, 0, 0}, Vec3::UnitY(), -Vec3::UnitX()),
          tube({-0.15, 0.3, 0}, Vec3::UnitX(), -Vec3::UnitY()), options};
}

constexpr double filled = -0.05;  // the distance in a film between the legs

TEST(Cleft, OpensAFilmThatNoCameraSaw) {
  const Cleft cleft = legs({});
  EXPECT_NEAR(cleft({0, 0.15, 0}, filled, 1), 0.01, 1e-3);
  EXPECT_NEAR(cleft({0.005, 0.15, 0}, filled, 1), 0.005, 1e-3);
  EXPECT_LT(cleft({0, 0.225, 0}, filled, 1), 0);  // above the roof
  EXPECT_GT(cleft({0, 0.205, 0}, filled, 1), 0);  // below
}

TEST(Cleft, BelievesWhatWasSeen) {
  const Cleft cleft = legs({});
  EXPECT_EQ(cleft({0, 0.15, 0.06}, 0.02, 0), 0.02);
  EXPECT_EQ(cleft({0.3, 0.15, 0}, 0.1, 1), 0.1);  // far from the cleft
  EXPECT_FALSE(cleft.changes({0.3, 0.15, 0}));
  EXPECT_TRUE(cleft.changes({0, 0.15, 0}));
}

TEST(Cleft, LeavesTheLeastGap) {
  const Cleft cleft = legs({.least_gap = 0.03});
  EXPECT_NEAR(cleft({0, 0.15, 0}, filled, 1), 0.015, 1e-3);
  EXPECT_NEAR(cleft({0.014, 0.15, 0}, filled, 1), 0.001, 1e-3);
}

TEST(Cleft, ARoofMayBeLifted) {
  const Cleft cleft = legs({.lift = 0.02});
  EXPECT_GT(cleft({0, 0.225, 0}, filled, 1), 0);
}

}  // namespace cleft_test
}  // namespace toile
