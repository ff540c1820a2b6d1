#include "pattern/import/fit_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "geometry/polygon.h"

namespace toile {
namespace fit_curve_test {

Vec2 point_of(const FittedCurve& curve, double t) {
  const auto& p = curve.points;
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

/// Metres: the farthest that the curves and the polyline are from each other.
double error_of(const std::vector<FittedCurve>& curves, const std::vector<Vec2>& points) {
  std::vector<Vec2> made;
  for (const FittedCurve& curve : curves) {
    for (int i = 0; i <= 100; ++i) made.push_back(point_of(curve, i / 100.0));
  }
  const auto farthest = [](const std::vector<Vec2>& from, const std::vector<Vec2>& line) {
    double most = 0;
    for (const Vec2& point : from) {
      double least = 1e9;
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        least = std::min(least, distance_to_segment(point, line[i], line[i + 1]));
      }
      most = std::max(most, least);
    }
    return most;
  };
  return std::max(farthest(made, points), farthest(points, made));
}

std::vector<Vec2> sampled(int count, const std::function<Vec2(double)>& curve) {
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) points.push_back(curve(static_cast<double>(i) / count));
  return points;
}

TEST(FitCurve, ALineIsOneLine) {
  const auto points = sampled(50, [](double t) { return Vec2(t, 2 * t); });
  const auto curves = fit_curves(points, 1e-4);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].straight);
}

TEST(FitCurve, ACubicIsOneCubic) {
  const FittedCurve drawn{{Vec2(0, 0), Vec2(0.1, 0.2), Vec2(0.3, -0.1), Vec2(0.4, 0.1)}};
  const auto points = sampled(400, [&](double t) { return point_of(drawn, t); });
  const auto curves = fit_curves(points, 1e-4);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_LT(error_of(curves, points), 1e-4);
}

TEST(FitCurve, AWaveIsAChainWithoutCorners) {
  const auto points = sampled(
      600, [](double t) { return Vec2(0.6 * t, 0.05 * std::sin(6 * std::numbers::pi * t)); });
  const auto curves = fit_curves(points, 1e-4);
  EXPECT_GT(curves.size(), 2u);
  // It is worth it: a tenth of the polyline's chords would do.
  EXPECT_LT(curves.size(), 60u);
  EXPECT_LT(error_of(curves, points), 1e-4);
  for (std::size_t i = 1; i < curves.size(); ++i) {
    EXPECT_EQ(curves[i].points[0], curves[i - 1].points[3]);
    const Vec2 in = curves[i - 1].points[3] - curves[i - 1].points[2];
    const Vec2 out = curves[i].points[1] - curves[i].points[0];
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    EXPECT_LT(std::abs(turn), 1e-6);
  }
}

/// Three and five points of a quarter of a circle are one curve, as many of them are.
TEST(FitCurve, FewPointsOfAnArcAreOneCurve) {
  for (const int chords : {2, 4}) {
    const auto points = sampled(chords, [](double t) {
      return Vec2(0.1 * std::cos(t * std::numbers::pi / 8),
                  0.1 * std::sin(t * std::numbers::pi / 8));
    });
    const auto curves = fit_curves(points, 6e-4);
    ASSERT_EQ(curves.size(), 1u) << chords;
    EXPECT_LT(error_of(curves, points), 6e-4);
  }
}

TEST(FitCurve, ANarrowBumpOfManyPointsIsFollowed) {
  // 4 mm wide and 0.7 mm high on a line of 2 m, in 4,000 chords.
  const auto points = sampled(4000, [](double t) {
    const double off = (t - 0.5) * 2 / 0.002;
    return Vec2(2 * t,
                std::abs(off) < 1 ? 7e-4 * std::pow(std::cos(off * std::numbers::pi / 2), 2) : 0);
  });
  EXPECT_LT(error_of(fit_curves(points, 1e-4), points), 1.05e-4);
}

TEST(FitCurve, CoarseChordsAreFollowedToTheTolerance) {
  // Chords of 14 mm on a radius of 100 mm leave their circle by 0.25 mm.
  const auto points =
      sampled(12, [](double t) { return Vec2(0.1 * std::cos(1.7 * t), 0.1 * std::sin(1.7 * t)); });
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    EXPECT_LT(error_of(fit_curves(points, tolerance), points), tolerance);
  }
}

}  // namespace fit_curve_test
}  // namespace toile
