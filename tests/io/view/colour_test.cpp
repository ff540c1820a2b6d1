#include "io/view/colour.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "geometry/types.h"

namespace toile {
namespace colour_test {

double luminance(const Colour& c) {
  return 0.2126 * to_light(c.red) + 0.7152 * to_light(c.green) + 0.0722 * to_light(c.blue);
}

TEST(Colour, OklchOfKnownColours) {
  // White, and sRGB red, whose OKLCh coordinates are published with the space.
  const Colour white = oklch(1, 0, 0);
  EXPECT_NEAR(white.red, 1, 1e-3);
  EXPECT_NEAR(white.green, 1, 1e-3);
  EXPECT_NEAR(white.blue, 1, 1e-3);
  const Colour red = oklch(0.62796, 0.25768, 29.234);
  EXPECT_NEAR(red.red, 1, 2e-3);
  EXPECT_NEAR(red.green, 0, 2e-2);
  EXPECT_NEAR(red.blue, 0, 2e-2);
}

TEST(Colour, LightRoundTrip) {
  for (double v = 0; v <= 1; v += 0.01) EXPECT_NEAR(from_light(to_light(v)), v, 1e-5);
}

TEST(Colour, MagnitudeRampDarkensSteadily) {
  const ColourRamp ramp = magnitude_ramp(0, 10);
  for (double v = 0; v < 10; v += 0.25) {
    EXPECT_GT(luminance(ramp.at(v)), luminance(ramp.at(v + 0.25)) + 1e-3) << v;
  }
}

TEST(Colour, BelowTheRampIsFarFromAllOfIt) {
  const ColourRamp ramp = magnitude_ramp(0, 10);
  const Colour below = ramp.at(-0.001);
  EXPECT_EQ(below.red, ramp.below.red);
  for (double v = 0; v <= 10; v += 0.25) {
    const Colour c = ramp.at(v);
    EXPECT_GT(std::hypot(c.red - below.red, c.green - below.green, c.blue - below.blue), 0.4) << v;
  }
}

TEST(Colour, TwoSidedRampDarkensAwayFromZero) {
  const ColourRamp ramp = two_sided_ramp(10, true);
  EXPECT_GT(luminance(ramp.at(0)), 0.85);
  for (double v = 0; v < 10; v += 0.5) {
    EXPECT_GT(luminance(ramp.at(v)), luminance(ramp.at(v + 0.5)) + 5e-3) << v;
    EXPECT_GT(luminance(ramp.at(-v)), luminance(ramp.at(-v - 0.5)) + 5e-3) << v;
    // Equally far from zero is equally light.
    EXPECT_NEAR(luminance(ramp.at(v)), luminance(ramp.at(-v)), 0.06) << v;
  }
  EXPECT_GT(ramp.at(-6).red, ramp.at(-6).blue + 0.2);
  EXPECT_GT(ramp.at(6).blue, ramp.at(6).red + 0.2);
  EXPECT_LT(luminance(ramp.at(-11)), 0.05);
}

// As an eye without red cones sees: linear light projected as by Viénot, Brettel & Mollon 1999.
Vec3 seen_without_red(const Colour& c) {
  const Vec3 light(to_light(c.red), to_light(c.green), to_light(c.blue));
  Eigen::Matrix3d shown;
  shown << 0.11238, 0.88762, 0, 0.11238, 0.88762, 0, 0.00401, -0.00401, 1;
  return shown * light;
}

TEST(Colour, WarmAndCoolDifferForTheColourBlind) {
  const ColourRamp ramp = two_sided_ramp(10, true);
  for (double v = 4; v <= 10; v += 1) {
    EXPECT_GT((seen_without_red(ramp.at(v)) - seen_without_red(ramp.at(-v))).norm(), 0.15) << v;
  }
}

TEST(Colour, AboveTheRamp) {
  ColourRamp ramp = warm_ramp(5);
  EXPECT_EQ(ramp.at(6).red, ramp.at(5).red);
  ramp.above = beyond_colour();
  EXPECT_EQ(ramp.at(6).red, beyond_colour().red);
  EXPECT_EQ(ramp.at(5).red, ramp.steps.back().red);
}

TEST(Colour, RampEnds) {
  const ColourRamp ramp{2, 4, {{0, 0, 0}, {1, 1, 1}}, {1, 0, 0}};
  EXPECT_EQ(ramp.at(2).green, 0);
  EXPECT_NEAR(ramp.at(3).green, 0.5, 1e-12);
  EXPECT_EQ(ramp.at(4).green, 1);
  EXPECT_EQ(ramp.at(1e9).green, 1);
  EXPECT_EQ(ramp.at(NAN).green, 0);
}

TEST(Colour, RoundTicks) {
  EXPECT_EQ(round_ticks(0, 60, 7), (std::vector<double>{0, 10, 20, 30, 40, 50, 60}));
  EXPECT_EQ(round_ticks(0, 40, 7), (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35, 40}));
  EXPECT_EQ(round_ticks(-5, 5, 3), (std::vector<double>{-5, 0, 5}));
}

TEST(Colour, RoundUp) {
  EXPECT_DOUBLE_EQ(round_up(37), 40);
  EXPECT_DOUBLE_EQ(round_up(40), 40);
  EXPECT_DOUBLE_EQ(round_up(0.011), 0.015);
  EXPECT_DOUBLE_EQ(round_up(81), 100);
}

}  // namespace colour_test
}  // namespace toile
