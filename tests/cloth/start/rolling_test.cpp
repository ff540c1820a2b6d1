#include "cloth/start/rolling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "tests/cloth/panels.h"

namespace toile {
namespace rolling_test {

constexpr double pi = std::numbers::pi;
/// The panel of reference case 14: metres, O_x at its middle.
constexpr double width = 0.5;
constexpr double height = 0.6;

Vec3 rolled(const Vec2& flat, double radius) { return roll(flat, width / 2, radius); }

/// As printed [Zhong & Xu 2009], read with O_z = z_min - r, z_min = 0.
Vec3 roll_as_printed(const Vec3& p, double radius) {
  const double theta = std::hypot(p.x(), p.z()) / radius;
  const double alpha = p.x() > 0 ? 1 : -1;
  return {alpha * radius * std::sin(theta), p.y(), radius * std::cos(theta) - radius};
}

TEST(Rolling, RadiusAndSeamGapAreThoseOfTheReference) {
  // Reference case 14, seam gap: zeta, r, gap along the arc, gap along the chord.
  struct Row {
    double zeta, radius, arc, chord;
  };
  constexpr Row rows[] = {{0, 0.0795774715459477, 0, 0},
                          {0.001, 0.0805774715459477, 0.00628318530717959, 0.00628159358200978},
                          {0.005, 0.0845774715459477, 0.0314159265358979, 0.0312356330875422},
                          {0.01, 0.0895774715459477, 0.0628318530717959, 0.0615517071378276},
                          {0.02, 0.0995774715459477, 0.125663706143592, 0.117489481567065},
                          {0.05, 0.129577471545948, 0.314159265358979, 0.242674281595312},
                          {-0.005, 0.0745774715459477, -0.0314159265358979, 0.031184155224945}};
  double worst = 0;
  for (const Row& row : rows) {
    const double radius = rolling_radius(width, 1, row.zeta);
    const double chord = (rolled({width, 0}, radius) - rolled({0, 0}, radius)).norm();
    worst = std::max({worst, std::abs(radius - row.radius),
                      std::abs(seam_gap(width, 1, radius) - row.arc), std::abs(chord - row.chord)});
  }
  std::cout << "radius and seam gap: off by " << worst << " m at most\n";
  EXPECT_LT(worst, 1e-12);
  // Two halves: the radius comes from the sum of their widths.
  EXPECT_DOUBLE_EQ(rolling_radius(0.3, 0.5, 0), rolling_radius(0.6, 1, 0));
  EXPECT_NEAR(seam_gap(0.3, 0.5, rolling_radius(0.3, 0.5, 0.01)), pi * 0.01, 1e-15);
}

TEST(Rolling, EdgesAreShortenedByTheChordErrorAlone) {
  // Reference case 14, chord error at zeta = 1 cm. Columns, then the relative errors of an edge
  // around, an edge at 45 degrees, the area and the perimeter.
  struct Row {
    int columns;
    double around, diagonal, area, perimeter;
  };
  constexpr Row rows[] = {
      {4, -0.0791833933257057, -0.0387759826327783, -0.0791833933257057, -0.0359924515116844},
      {16, -0.00506326303943971, -0.00252841881241384, -0.00506326303943971, -0.00230148319974532},
      {64, -0.000316905609386353, -0.000158440249058089, -0.000316905609386353,
       -0.000144048004266484},
      {256, -1.98083661939741e-05, -9.90413405010937e-06, -1.98083661939741e-05,
       -9.00380281565472e-06}};
  const double radius = rolling_radius(width, 1, 0.01);
  double worst = 0;
  for (const Row& row : rows) {
    const double h = width / row.columns;
    const PlanarMesh mesh = test::grid(width, height, row.columns, 8);
    double area = 0;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 a = rolled(mesh.points[t[0]], radius);
      const Vec3 u = rolled(mesh.points[t[1]], radius) - a;
      const Vec3 v = rolled(mesh.points[t[2]], radius) - a;
      area += std::sqrt(u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v)) / 2;
    }
    double around = 0;
    for (int i = 0; i < row.columns; ++i) {
      around += (rolled({(i + 1) * h, 0}, radius) - rolled({i * h, 0}, radius)).norm();
    }
    const double diagonal = (rolled({h, h}, radius) - rolled({0, 0}, radius)).norm();
    const double errors[] = {around / width - 1 - row.around,
                             diagonal / (h * std::sqrt(2.0)) - 1 - row.diagonal,
                             area / (width * height) - 1 - row.area,
                             (around + height) / (width + height) - 1 - row.perimeter};
    for (const double error : errors) worst = std::max(worst, std::abs(error));
  }
  std::cout << "chord errors: off by " << worst << " at most\n";
  EXPECT_LT(worst, 1e-12);
}

TEST(Rolling, LengthsAreKeptEverywhere) {
  const double radius = rolling_radius(width, 1, 0.01);
  constexpr double h = 1e-6;
  double worst = 0;
  for (const double x : {0.0, 0.01, 0.05, 0.125, 0.25, 0.4}) {
    for (const Vec2& along : {Vec2(1, 0), Vec2(0, 1), Vec2(0.6, 0.8)}) {
      const Vec3 a = rolled(Vec2(x, 0.3) - h * along, radius);
      const Vec3 b = rolled(Vec2(x, 0.3) + h * along, radius);
      worst = std::max(worst, std::abs((b - a).norm() / (2 * h) - 1));
    }
  }
  std::cout << "isometry: strain " << worst << " at most\n";
  EXPECT_LT(worst, 1e-9);
}

TEST(Rolling, ThePrintedFormCrushesPanelsThatAreNotFlatAtTheirLowest) {
  // Reference case 14, isometry: z - z_min at O_x, its slope, distance from O_x, local stretch. The
  // middle of a panel that lies 1 cm too high is crushed by 29 %.
  struct Row {
    double lift, slope, x, stretch;
  };
  constexpr Row rows[] = {{0, 0, 0.05, 1},
                          {0.001, 0, 0.01, 0.995037682749115},
                          {0.01, 0, 0.01, 0.707124457971322},
                          {0.01, 0, 0.05, 0.980581052818115},
                          {0.05, 0, 0.01, 0.196125563759447},
                          {0.05, 0, 0.05, 0.707110316683618},
                          {0.05, 0, 0.125, 0.928477203146822},
                          {0.05, 0, 0.25, 0.980580600257067},
                          {0.125, 0.5, 0.01, 0.514498907935992},
                          {0.125, 0.5, 0.05, 0.707108548943825},
                          {0.125, 0.5, 0.25, 0.948683139969585}};
  const double radius = rolling_radius(width, 1, 0.01);
  constexpr double h = 1e-6;
  double worst = 0;
  double off_closed_form = 0;
  for (const Row& row : rows) {
    const auto lifted = [&](double x) { return Vec3(x, 0, row.lift + row.slope * x); };
    const Vec3 a = roll_as_printed(lifted(row.x - h), radius);
    const Vec3 b = roll_as_printed(lifted(row.x + h), radius);
    const double stretch = (b - a).norm() / (lifted(row.x + h) - lifted(row.x - h)).norm();
    worst = std::max(worst, std::abs(stretch - row.stretch));
    const Vec3 at = lifted(row.x);
    const double closed =
        (at.x() + row.slope * at.z()) / (std::hypot(at.x(), at.z()) * std::hypot(1, row.slope));
    off_closed_form = std::max(off_closed_form, std::abs(stretch - closed));
  }
  // Where the panel is flat at z_min, both forms are one.
  double apart = 0;
  for (int i = 0; i <= 50; ++i) {
    const Vec2 flat(width * i / 50, 0.2);
    const Vec3 printed = roll_as_printed({flat.x() - width / 2, flat.y(), 0}, radius);
    apart = std::max(apart, (printed + Vec3(0, 0, radius) - rolled(flat, radius)).norm());
  }
  std::cout << "printed form: off the reference's stretch by " << worst
            << ", off the closed form by " << off_closed_form << "; off ours by " << apart
            << " m where flat\n";
  EXPECT_LT(off_closed_form, 1e-9);
  EXPECT_LT(worst, 2e-5);  // the reference differentiates in longer steps
  EXPECT_LT(apart, 1e-15);
}

}  // namespace rolling_test
}  // namespace toile
