#include "io/dxf_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace dxf_curves_test {

Vec2 point_of(const DxfCurve& curve, double t) {
  const auto& p = curve.points;
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

TEST(DxfCurves, ABulgeOfOneIsAHalfCircleToTheRight) {
  // Positive bulges run counter-clockwise: from (0,0) to (2,0) below the chord.
  std::vector<DxfCurve> curves;
  append_dxf_bulge(curves, {0, 0}, {2, 0}, 1);
  double lowest = 0;
  for (const DxfCurve& curve : curves) {
    for (int i = 0; i <= 10; ++i) {
      const Vec2 point = point_of(curve, i / 10.0);
      EXPECT_NEAR((point - Vec2(1, 0)).norm(), 1, 1e-7);
      lowest = std::min(lowest, point.y());
    }
  }
  EXPECT_NEAR(lowest, -1, 1e-7);
  EXPECT_EQ(curves.front().points[0], Vec2(0, 0));
  EXPECT_EQ(curves.back().points[3], Vec2(2, 0));
}

TEST(DxfCurves, ACubicBSplineIsExact) {
  // Uniform knots and control points of the parabola's polar form: x = t, y = t * t on [0, 1, 2].
  DxfSpline spline;
  spline.degree = 2;
  spline.knots = {0, 0, 0, 1, 2, 2, 2};
  // Polar form of (t, t^2): ((a + b) / 2, a * b).
  spline.control_points = {{0, 0}, {0.5, 0}, {1.5, 2}, {2, 4}};
  ASSERT_EQ(spline_problem(spline), "");
  const std::vector<DxfCurve> curves = spline_curves(spline);
  ASSERT_EQ(curves.size(), 2u);
  for (const DxfCurve& curve : curves) {
    for (const double t : {0.0, 0.3, 0.8, 1.0}) {
      const Vec2 point = point_of(curve, t);
      EXPECT_NEAR(point.y(), point.x() * point.x(), 1e-12);
    }
  }
}

TEST(DxfCurves, AWeightedSplineIsACircle) {
  DxfSpline spline;
  spline.degree = 2;
  spline.knots = {0, 0, 0, 1, 1, 1};
  spline.control_points = {{100, 0}, {100, 100}, {0, 100}};
  spline.weights = {1, std::sqrt(0.5), 1};
  for (const DxfCurve& curve : spline_curves(spline)) {
    EXPECT_NEAR(point_of(curve, 0.5).norm(), 100, 1e-4);
  }
}

TEST(DxfCurves, FitPointsAreInterpolated) {
  // A natural spline through points of a line is that line; through others it meets each.
  DxfSpline spline;
  spline.fit_points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
  const std::vector<DxfCurve> curves = spline_curves(spline);
  ASSERT_EQ(curves.size(), 3u);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    EXPECT_TRUE(curves[i].points[0].isApprox(spline.fit_points[i], 1e-12) || i == 0);
    if (i == 0) continue;
    // Neighbours share their direction.
    const Vec2 in = curves[i - 1].points[3] - curves[i - 1].points[2];
    const Vec2 out = curves[i].points[1] - curves[i].points[0];
    EXPECT_NEAR(in.x() * out.y() - in.y() * out.x(), 0, 1e-12);
  }
  // Symmetric points give a symmetric curve.
  EXPECT_NEAR(point_of(curves[1], 0.5).x(), 2, 1e-12);
}

TEST(DxfCurves, NamesWhatIsWrongWithASpline) {
  DxfSpline spline;
  EXPECT_NE(spline_problem(spline), "");
  spline.control_points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  EXPECT_NE(spline_problem(spline), "");
  spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  EXPECT_EQ(spline_problem(spline), "");
  spline.knots[4] = -1;
  EXPECT_NE(spline_problem(spline), "");
}

}  // namespace dxf_curves_test
}  // namespace toile
