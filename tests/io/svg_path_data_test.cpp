#include "io/svg_path_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/error.h"

namespace toile {
namespace svg_path_data_test {

std::vector<DrawnPath> read(const std::string& data) {
  return svg_path_data(data, "x.svg:1: path");
}

std::string message_of(const std::string& data) {
  try {
    read(data);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The corners of a path of lines.
std::vector<Vec2> corners(const DrawnPath& path) {
  std::vector<Vec2> points = {path.start};
  for (const DrawnSegment& segment : path.segments) points.push_back(segment.end);
  return points;
}

TEST(SvgPathData, RelativeAndAbsoluteCommandsDrawTheSame) {
  const std::vector<Vec2> square = {{1, 2}, {4, 2}, {4, 6}, {1, 6}, {1, 2}};
  for (const char* data : {"M1 2L4 2L4 6L1 6Z", "M1,2 4,2 4,6 1,6z", "m1 2h3v4h-3z",
                           "m1 2 3 0 0 4-3 0z", "M1 2H4V6H1V2", "M 1 2 l 3.0.0 0 4 -3 0 z"}) {
    const auto paths = read(data);
    ASSERT_EQ(paths.size(), 1u) << data;
    EXPECT_EQ(corners(paths[0]), square) << data;
    EXPECT_EQ(paths[0].closed, std::string(data).find_first_of("zZ") != std::string::npos) << data;
  }
}

TEST(SvgPathData, AfterACloseTheNextPathStartsWhereTheLastOneDid) {
  const auto paths = read("M1 1h2v2zl5 5M0 0m1 1");
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_EQ(corners(paths[1]), (std::vector<Vec2>{{1, 1}, {6, 6}}));
  EXPECT_FALSE(paths[1].closed);
}

TEST(SvgPathData, SmoothCurvesGoOnInTheirDirection) {
  const auto cubic = read("M0 0C0 1 1 2 2 2S4 1 4 0s1-2 2-2");
  ASSERT_EQ(cubic[0].segments.size(), 3u);
  EXPECT_EQ(cubic[0].segments[1].control1, Vec2(3, 2));
  EXPECT_EQ(cubic[0].segments[2].control1, Vec2(4, -1));
  EXPECT_EQ(cubic[0].segments[2].end, Vec2(6, -2));
  // After a line there is nothing to go on from.
  EXPECT_EQ(read("M0 0L1 0S3 1 3 2")[0].segments[1].control1, Vec2(1, 0));
  const auto quadratic = read("M0 0Q1 1 2 0T4 0t2 0");
  // The control points of a quadratic lie 2/3 of the way to its own.
  EXPECT_TRUE(quadratic[0].segments[1].control1.isApprox(Vec2(2 + 2.0 / 3, -2.0 / 3)));
  EXPECT_TRUE(quadratic[0].segments[2].control1.isApprox(Vec2(4 + 2.0 / 3, 2.0 / 3)));
}

TEST(SvgPathData, ArcsLieOnTheirEllipse) {
  // Radii of 1 m: 4.2e-6 of that is the bound.
  for (const char* flags : {"0 0", "0 1", "1 0", "1 1"}) {
    const std::string data = "M 700 0 A 1000 1000 0 " + std::string(flags) + " 0 700";
    const DrawnPath path = read(data)[0];
    const bool far_side = std::string(flags) == "0 1" || std::string(flags) == "1 0";
    const double half = std::sqrt(1000.0 * 1000 - 2 * 350 * 350);
    const Vec2 along = Vec2(1, 1).normalized() * half;
    const Vec2 middle(350, 350);
    const Vec2 centre = far_side ? Vec2(middle - along) : Vec2(middle + along);
    for (const Vec2& point : path_vertices(path, 1e-3)) {
      EXPECT_NEAR((point - centre).norm(), 1000, 5e-3) << flags;
    }
    EXPECT_EQ(end_of(path), Vec2(0, 700));
    double length = 0;
    const auto points = path_vertices(path, 1e-3);
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    const double small = 2 * std::asin(350 * std::sqrt(2.0) / 1000) * 1000;
    const bool large = flags[0] == '1';
    EXPECT_NEAR(length, large ? 2 * std::numbers::pi * 1000 - small : small, 1) << flags;
  }
}

TEST(SvgPathData, TiltedAndTooSmallArcs) {
  // A tilted ellipse with half axes 4 and 2, from one end of the long axis to the other.
  const double c = std::cos(std::numbers::pi / 6);
  const DrawnPath tilted =
      read("M" + std::to_string(-4 * c) + " -2 A4 2 30 0 1 " + std::to_string(4 * c) + " 2")[0];
  for (const Vec2& point : path_vertices(tilted, 1e-4)) {
    const double along = c * point.x() + 0.5 * point.y();
    const double across = -0.5 * point.x() + c * point.y();
    EXPECT_NEAR(along * along / 16 + across * across / 4, 1, 1e-4);
  }
  // Radii that do not reach become half the distance.
  for (const Vec2& point : path_vertices(read("M0 0A1 1 0 0 1 10 0")[0], 1e-4)) {
    EXPECT_NEAR((point - Vec2(5, 0)).norm(), 5, 1e-4);
  }
  EXPECT_FALSE(read("M0 0A0 5 0 0 1 10 10")[0].segments[0].curved);
  EXPECT_TRUE(read("M3 3A5 5 0 0 1 3 3").empty());
  EXPECT_EQ(end_of(read("M0 0a5 5 0 0110 0")[0]), Vec2(10, 0));  // flags without blanks
  EXPECT_EQ(end_of(read("M0 0A1e300 1e300 0 0 1 1 0")[0]), Vec2(1, 0));
}

TEST(SvgPathData, WhatCanNotBeReadIsAnErrorWithItsPlace) {
  EXPECT_EQ(
      message_of("M0 0L5"),
      "x.svg:1: path: a number is missing at character 7; open the drawing and save it again");
  for (const char* data : {"L1 1", "0 0", "M0 0X1", "M0 0L1 nan", "M0 0L1 1e999",
                           "M0 0 A1 1 0 2 0 1 1", "M", "z", "M0 0zz5", "M0 0L1 1 &a;"}) {
    EXPECT_NE(message_of(data), "") << data;
  }
}

TEST(SvgPathData, RectanglesAndEllipses) {
  EXPECT_EQ(corners(svg_rectangle({1, 2}, {3, 4}, {0, 0})),
            (std::vector<Vec2>{{1, 2}, {4, 2}, {4, 6}, {1, 6}, {1, 2}}));
  // Round corners take away (4 - pi) r^2 of the area.
  const auto points = path_vertices(svg_rectangle({0, 0}, {10, 8}, {2, 2}), 1e-6);
  double area = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    area += (points[i].x() * points[i + 1].y() - points[i].y() * points[i + 1].x()) / 2;
  }
  EXPECT_NEAR(area, 80 - (4 - std::numbers::pi) * 4, 1e-3);
  for (const Vec2& point : path_vertices(svg_ellipse({1, 1}, {3, 2}), 1e-3)) {
    EXPECT_NEAR(std::pow((point.x() - 1) / 3, 2) + std::pow((point.y() - 1) / 2, 2), 1, 1e-3);
  }
}

}  // namespace svg_path_data_test
}  // namespace toile
