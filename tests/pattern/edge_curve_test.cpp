#include "pattern/edge_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace edge_curve_test {

constexpr double pi = std::numbers::pi;

/// Length of the parabola y = a x^2 from x = 0 to x = w, in closed form.
double parabola_length(double a, double w) {
  const double u = 2 * a * w;
  return (u * std::sqrt(1 + u * u) + std::asinh(u)) / (4 * a);
}

TEST(EdgeCurve, ALineIsItsChord) {
  const EdgeCurve line = EdgeCurve::line({1, 2}, {4, 6});
  EXPECT_DOUBLE_EQ(line.length(), 5);
  EXPECT_TRUE(line.at(0.25).isApprox(Vec2(1.75, 3)));
  EXPECT_EQ(line.turning(), 0);
}

TEST(EdgeCurve, AChainIsWalkedAsOneCurve) {
  // A quarter circle of radius 1 and a line of length 1.
  const EdgeCurve chain = EdgeCurve::chain(
      {EdgeCurve::arc({1, 0}, {0, 1}, 1, false, true), EdgeCurve::line({0, 1}, {-1, 1})});
  EXPECT_NEAR(chain.length(), pi / 2 + 1, 1e-12);
  EXPECT_TRUE(chain.at(pi / 2 / (pi / 2 + 1)).isApprox(Vec2(0, 1), 1e-9));
  EXPECT_TRUE(
      chain.at((pi / 4) / (pi / 2 + 1)).isApprox(Vec2(std::sqrt(0.5), std::sqrt(0.5)), 1e-9));
  EXPECT_NEAR(chain.turning(), pi / 2, 0.05);
  const EdgeCurve moved = chain.moved_to({10, 10}, {12, 11});
  const double scale = std::sqrt(5.0) / (Vec2(-1, 1) - Vec2(1, 0)).norm();
  EXPECT_NEAR(moved.length(), scale * chain.length(), 1e-9);
  EXPECT_EQ(moved.start(), Vec2(10, 10));
  EXPECT_EQ(moved.end(), Vec2(12, 11));
  const EdgeCurve back = chain.reversed();
  for (const double f : {0.0, 0.2, 0.7, 1.0}) {
    EXPECT_TRUE(back.at(f).isApprox(chain.at(1 - f), 1e-9));
  }
  EXPECT_EQ(chain.straight_at_start(0.5).end(), chain.end());
}

TEST(EdgeCurve, AReversedCurveRunsBack) {
  const std::vector<EdgeCurve> curves = {
      EdgeCurve::line({0, 0}, {1, 2}), EdgeCurve::cubic({0, 0}, {1, 2}, {3, -1}, {2, 2}),
      EdgeCurve::arc({0, 0}, {1, 1}, 2, true, false),
      EdgeCurve::cubic({0, 0}, {1, 2}, {3, -1}, {2, 2}).straight_at_start(0.3)};
  for (const EdgeCurve& curve : curves) {
    const EdgeCurve back = curve.reversed();
    EXPECT_NEAR(back.length(), curve.length(), 1e-12);
    for (const double f : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      EXPECT_LT((back.at(f) - curve.at(1 - f)).norm(), 1e-9);
    }
  }
}

TEST(EdgeCurve, AQuadraticHasTheParabolasLength) {
  // The Bezier curve (0,0), (w/2,0), (w,a w^2) is the parabola y = a x^2.
  for (const double a : {0.1, 1.0, 25.0}) {
    const double w = 0.7;
    const EdgeCurve curve = EdgeCurve::quadratic({0, 0}, {w / 2, 0}, {w, a * w * w});
    EXPECT_NEAR(curve.length(), parabola_length(a, w), 1e-12 * curve.length());
    // Half the length ends where the closed form says: its length from 0 is half.
    const Vec2 half = curve.at(0.5);
    EXPECT_NEAR(half.y(), a * half.x() * half.x(), 1e-12);
    EXPECT_NEAR(parabola_length(a, half.x()), curve.length() / 2, 1e-11);
  }
}

TEST(EdgeCurve, ArcsAreExactForAllFourFlags) {
  const Vec2 start(0, 0);
  const Vec2 end(1, 0);
  const double radius = 1;
  const double small_angle = pi / 3;
  for (const bool large : {false, true}) {
    for (const bool right : {false, true}) {
      const EdgeCurve arc = EdgeCurve::arc(start, end, radius, large, right);
      const double angle = large ? 2 * pi - small_angle : small_angle;
      EXPECT_NEAR(arc.length(), radius * angle, 1e-15);
      EXPECT_NEAR(arc.turning(), angle, 1e-15);
      const Vec2 middle = arc.at(0.5);
      EXPECT_NEAR(middle.x(), 0.5, 1e-15);
      // Right of the direction from start to end is below the chord.
      const double sagitta = radius * (1 - std::cos(angle / 2));
      EXPECT_NEAR(middle.y(), right ? -sagitta : sagitta, 1e-15);
      EXPECT_EQ(arc.at(0), start);
      EXPECT_EQ(arc.at(1), end);
    }
  }
}

TEST(EdgeCurve, AHalfCircleMayBeGivenATooShortRadius) {
  const EdgeCurve arc = EdgeCurve::arc({0, 0}, {2, 0}, 0.999999, false, true);
  EXPECT_NEAR(arc.length(), pi, 1e-12);
}

TEST(EdgeCurve, StepsOfEqualFractionAreStepsOfEqualLength) {
  // An S with a strong change of speed; a nearly cusped curve; one that runs back over itself.
  const std::vector<EdgeCurve> curves = {
      EdgeCurve::cubic({0, 0}, {2, 1}, {-1, 1.5}, {1, 2}),
      EdgeCurve::cubic({0, 0}, {1, 1}, {0.001, 1}, {1, 0}),
      EdgeCurve::cubic({0, 0}, {1, 0}, {-0.5, 0}, {0.2, 0}),
  };
  for (const EdgeCurve& curve : curves) {
    // A polyline of many points on each stretch measures it from below.
    constexpr int steps = 7;
    constexpr int fine = 4000;
    for (int i = 0; i < steps; ++i) {
      double length = 0;
      Vec2 before = curve.at(static_cast<double>(i) / steps);
      for (int k = 1; k <= fine; ++k) {
        const Vec2 next = curve.at((i + static_cast<double>(k) / fine) / steps);
        length += (next - before).norm();
        before = next;
      }
      EXPECT_NEAR(length, curve.length() / steps, 2e-4 * curve.length() / steps);
    }
  }
}

TEST(EdgeCurve, SamplesHoldBothEndsExactly) {
  const EdgeCurve curve = EdgeCurve::cubic({0.1, 0.7}, {2, 1}, {-1, 1.5}, {1.3, 2.9});
  const std::vector<Vec2> points = curve.sample(5);
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points.front(), curve.start());
  EXPECT_EQ(points.back(), curve.end());
}

TEST(EdgeCurve, TurningOfAQuarterAndOfPartsOfIt) {
  const EdgeCurve arc = EdgeCurve::arc({1, 0}, {0, 1}, 1, false, true);
  EXPECT_NEAR(arc.turning(), pi / 2, 1e-12);
  EXPECT_NEAR(arc.turning(0.25, 0.75), pi / 4, 1e-12);
  const EdgeCurve bezier = EdgeCurve::quadratic({0, 0}, {1, 0}, {1, 1});
  EXPECT_NEAR(bezier.turning(), pi / 2, 0.1);
}

TEST(EdgeCurve, MovedAsAWholeItKeepsItsShape) {
  const std::vector<EdgeCurve> curves = {EdgeCurve::line({1, 2}, {3, 3}),
                                         EdgeCurve::cubic({1, 2}, {2, 4}, {4, 1}, {3, 3}),
                                         EdgeCurve::arc({1, 2}, {3, 3}, 1.4, false, true),
                                         EdgeCurve::arc({1, 2}, {3, 3}, 1.4, true, false)};
  // A quarter turn, and twice as long.
  for (const EdgeCurve& curve : curves) {
    const EdgeCurve moved = curve.moved_to({0, 1}, {-2, 5});
    EXPECT_EQ(moved.start(), Vec2(0, 1));
    EXPECT_EQ(moved.end(), Vec2(-2, 5));
    EXPECT_NEAR(moved.length(), 2 * curve.length(), 1e-12);
    for (const double fraction : {0.2, 0.5, 0.9}) {
      const Vec2 arm = curve.at(fraction) - Vec2(1, 2);
      EXPECT_NEAR((moved.at(fraction) - Vec2(-2 * arm.y(), 1 + 2 * arm.x())).norm(), 0, 1e-12);
    }
  }
}

TEST(EdgeCurve, StraightAtAnEndItIsTheChordThere) {
  const EdgeCurve arc = EdgeCurve::arc({1, 0}, {0, 1}, 1, false, true);
  const double eighth = pi / 8;
  const EdgeCurve at_end = arc.straight_at_end(eighth);
  const EdgeCurve at_start = arc.straight_at_start(eighth);
  const double length = 3 * eighth + 2 * std::sin(eighth / 2);
  EXPECT_NEAR(at_end.length(), length, 1e-12);
  EXPECT_NEAR(at_start.length(), length, 1e-12);
  EXPECT_FALSE(at_end.straight());
  EXPECT_NEAR((at_end.at(3 * eighth / length) - arc.at(0.75)).norm(), 0, 1e-12);
  EXPECT_NEAR((at_end.at(eighth / length) - arc.at(0.25)).norm(), 0, 1e-12);
  // The middle of the chord.
  const Vec2 middle = (arc.at(0.75) + arc.end()) / 2;
  EXPECT_NEAR((at_end.at(1 - std::sin(eighth / 2) / length) - middle).norm(), 0, 1e-12);
  EXPECT_NEAR((at_start.at(std::sin(eighth / 2) / length) - Vec2(middle.y(), middle.x())).norm(), 0,
              1e-12);
  EXPECT_NEAR(at_end.turning(), pi / 2 - eighth / 2, 0.05);
  const EdgeCurve moved = at_end.moved_to({0, 0}, {-2, 2});
  EXPECT_NEAR(moved.length(), 2 * length, 1e-12);
  EXPECT_NEAR((moved.at(0.9) - 2 * (at_end.at(0.9) - Vec2(1, 0))).norm(), 0, 1e-12);
  EXPECT_EQ(EdgeCurve::line({0, 0}, {1, 1}).straight_at_end(0.1).at(0.5), Vec2(0.5, 0.5));
}

TEST(EdgeCurve, APointHasNoLengthAndNoDirection) {
  const EdgeCurve dot = EdgeCurve::cubic({1, 1}, {1, 1}, {1, 1}, {1, 1});
  EXPECT_EQ(dot.length(), 0);
  EXPECT_EQ(dot.at(0.3), Vec2(1, 1));
  EXPECT_EQ(EdgeCurve::arc({1, 1}, {1, 1}, 2, true, true).length(), 0);
}

}  // namespace edge_curve_test
}  // namespace toile
