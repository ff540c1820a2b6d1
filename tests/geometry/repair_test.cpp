#include "geometry/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/error.h"
#include "geometry/intersections.h"
#include "tests/support/shapes.h"

namespace toile {
namespace repair_test {

using test::is_closed;
using test::volume;

std::string error_of(const PolygonSoup& soup) {
  try {
    repair(soup, "body.obj");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

PolygonSoup without_triangles(const TriangleMesh& mesh, int first, int count) {
  PolygonSoup soup = test::soup(mesh);
  soup.polygons.erase(soup.polygons.begin() + first, soup.polygons.begin() + first + count);
  return soup;
}

TEST(Repair, ASoundSurfaceKeepsEveryBit) {
  const TriangleMesh ball = test::sphere(0.3, 4);
  const RepairedSurface result = repair(test::soup(ball), "ball");
  EXPECT_EQ(result.mesh.points, ball.points);
  ASSERT_EQ(result.mesh.triangles.size(), ball.triangles.size());
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_NEAR(volume(result.mesh), volume(ball), 1e-15);
  const RepairReport& r = result.report;
  EXPECT_EQ(r.points_merged + r.polygons_removed + r.points_split + r.polygons_triangulated +
                r.borders_stitched + r.components_dropped +
                static_cast<int>(r.holes_filled.size()) + r.self_intersections_found,
            0);
  EXPECT_FALSE(r.turned_inside_out);
}

TEST(Repair, LooseTrianglesAreJoined) {
  const TriangleMesh ball = test::sphere(1, 3);
  PolygonSoup loose;
  for (const Triangle& t : ball.triangles) {
    const int first = static_cast<int>(loose.points.size());
    for (const int corner : t) loose.points.push_back(ball.points[corner]);
    loose.polygons.push_back({first, first + 1, first + 2});
  }
  const RepairedSurface result = repair(loose, "ball");
  EXPECT_EQ(result.mesh.points.size(), ball.points.size());
  EXPECT_EQ(result.report.points_merged,
            static_cast<int>(loose.points.size() - ball.points.size()));
  EXPECT_TRUE(is_closed(result.mesh));
}

TEST(Repair, PolygonsThatDisagreeAreTurnedOutward) {
  PolygonSoup soup = test::soup(test::sphere(1, 3));
  std::mt19937 random(5);
  for (auto& polygon : soup.polygons) {
    if (random() % 2 == 0) std::swap(polygon[0], polygon[1]);
  }
  const RepairedSurface mixed = repair(soup, "ball");
  EXPECT_TRUE(is_closed(mixed.mesh));
  EXPECT_NEAR(volume(mixed.mesh), volume(test::sphere(1, 3)), 1e-12);
  const RepairedSurface inverted = repair(test::soup(test::inside_out(test::cube())), "cube");
  EXPECT_TRUE(inverted.report.turned_inside_out);
  EXPECT_NEAR(volume(inverted.mesh), 1, 1e-12);
}

TEST(Repair, QuadsDuplicatesAndSliversAreDealtWith) {
  PolygonSoup soup;
  soup.points = test::cube().points;
  soup.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3},
                   {0, 4, 6, 2}, {1, 3, 7, 5}, {1, 3, 7, 5}, {0, 0, 1}};
  soup.points.emplace_back(9, 9, 9);  // no polygon uses it
  const RepairedSurface result = repair(soup, "cube");
  EXPECT_EQ(result.mesh.points.size(), 8u);
  EXPECT_EQ(result.mesh.triangles.size(), 12u);
  EXPECT_EQ(result.report.polygons_triangulated, 6);
  EXPECT_EQ(result.report.polygons_removed, 2);
  EXPECT_EQ(result.report.points_merged, 1);
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_NEAR(volume(result.mesh), 1, 1e-12);
}

TEST(Repair, SmallHolesAreFilled) {
  const TriangleMesh ball = test::sphere(1, 4);
  const RepairedSurface result = repair(without_triangles(ball, 8, 4), "ball");
  ASSERT_EQ(result.report.holes_filled.size(), 1u);
  EXPECT_GT(result.report.holes_filled[0].across, 0.05);
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_NEAR(volume(result.mesh), volume(ball), 0.002 * volume(ball));
}

TEST(Repair, LargeHolesAreAnErrorWithCountAndSize) {
  const std::string message = error_of(without_triangles(test::cube(), 0, 2));
  EXPECT_NE(message.find("1 hole is too large"), std::string::npos) << message;
  EXPECT_NE(message.find("1.41 units across"), std::string::npos) << message;
  EXPECT_NE(message.find("141 %"), std::string::npos) << message;
}

TEST(Repair, AMoebiusStripIsOneSided) {
  PolygonSoup strip;
  const int around = 40;
  for (int i = 0; i < around; ++i) {
    const double turn = 2 * std::numbers::pi * i / around;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1 + side * std::cos(turn / 2);
      strip.points.emplace_back(radius * std::cos(turn), side * std::sin(turn / 2),
                                radius * std::sin(turn));
    }
  }
  for (int i = 0; i < around; ++i) {
    const int a = 2 * i;
    const int b = 2 * i + 1;
    const bool last = i + 1 == around;
    const int c = last ? 1 : a + 2;
    const int d = last ? 0 : b + 2;
    strip.polygons.push_back({a, b, d, c});
  }
  EXPECT_NE(error_of(strip).find("one-sided"), std::string::npos) << error_of(strip);
}

TEST(Repair, OnlyTheLargestPartIsKept) {
  const TriangleMesh body = test::sphere(1, 4);
  TriangleMesh cavity = test::inside_out(test::sphere(0.2, 2));
  const RepairedSurface result = repair(test::soup(test::together(cavity, body)), "body");
  EXPECT_EQ(result.report.components_dropped, 1);
  EXPECT_NEAR(result.report.dropped_area, 0.04 / 1.04, 0.005);
  EXPECT_NEAR(volume(result.mesh), volume(body), 1e-12);
}

TEST(Repair, SelfIntersectionsAreRemovedWithoutMovingTheSurfaceFar) {
  // One point of a fine ball pushed through its neighbours.
  TriangleMesh ball = test::sphere(1, 5);
  const int pushed = ball.triangles[100][0];
  const int beyond = ball.triangles[104][2];
  ball.points[pushed] =
      1.0005 * ball.points[beyond] + 0.6 * (ball.points[beyond] - ball.points[pushed]);
  ASSERT_FALSE(self_intersections(ball).empty());
  RepairOptions options;
  options.largest_move = 0.05;
  const RepairedSurface result = repair(test::soup(ball), "ball", options);
  EXPECT_GT(result.report.self_intersections_found, 0);
  EXPECT_EQ(result.report.self_intersections_left, 0);
  EXPECT_TRUE(self_intersections(result.mesh).empty());
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_LE(result.report.largest_move, 0.05 * 2.01);

  // If it may not move the surface, it leaves it as it is and reports the intersections.
  options.largest_move = 0;
  const RepairedSurface kept = repair(test::soup(ball), "ball", options);
  EXPECT_EQ(kept.report.self_intersections_left, kept.report.self_intersections_found);
  EXPECT_EQ(kept.mesh.points, ball.points);
}

// CGAL divides by products of coordinates, which underflow to 0.
TEST(Repair, TinyCoordinatesCountAsZero) {
  PolygonSoup box;
  box.points = {{0, -1e-300, -1e-300}, {1, 0, 0},     {1, 2, 0}, {0, 2, 0}, {0, 0, 1}, {1, 0, 1},
                {-1e-300, 2, -1e-300}, {0, 2, 5e-324}};
  box.polygons = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  const RepairedSurface result = repair(box, "box.off");
  EXPECT_TRUE(is_closed(result.mesh));
  for (const Vec3& p : result.mesh.points) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(p[axis] == 0 || p[axis] >= 1) << p[axis];
  }
}

TEST(Repair, WhatEnclosesNothingIsAnError) {
  EXPECT_NE(error_of({}).find("no polygons"), std::string::npos);
  PolygonSoup flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flat.polygons = {{0, 1, 2, 3}};
  EXPECT_NE(error_of(flat), "no error");
  flat.polygons = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_NE(error_of(flat), "no error");
  flat.polygons = {{0, 0, 0}, {1, 1, 2}};
  EXPECT_NE(error_of(flat), "no error");
  PolygonSoup infinite = test::soup(test::cube());
  infinite.points[3].y() = std::numeric_limits<double>::infinity();
  EXPECT_NE(error_of(infinite).find("point 4"), std::string::npos);
  infinite.points[3].y() = std::nan("");
  EXPECT_NE(error_of(infinite).find("point 4"), std::string::npos);
  infinite.points[3].y() = 1e300;
  EXPECT_NE(error_of(infinite).find("point 4"), std::string::npos);
}

TEST(Repair, AnySoupEndsClosedOrAsAnError) {
  std::mt19937 random(99);
  const auto coordinate = [&random] { return static_cast<double>(random() % 5) / 4; };
  int closed = 0;
  for (int round = 0; round < 600; ++round) {
    // Half of the soups are random polygons, half are damaged balls.
    PolygonSoup soup;
    if (round % 2 == 0) {
      const int points = 3 + static_cast<int>(random() % 8);
      for (int i = 0; i < points; ++i) {
        soup.points.emplace_back(coordinate(), coordinate(), coordinate());
      }
      for (std::size_t i = 1 + random() % 20; i > 0; --i) {
        auto& polygon = soup.polygons.emplace_back();
        for (std::size_t corners = 3 + random() % 3; corners > 0; --corners) {
          polygon.push_back(static_cast<int>(random() % points));
        }
      }
    } else {
      soup = test::soup(test::sphere(1, 2));
      for (int damage = 0; damage < 3; ++damage) {
        auto& polygon = soup.polygons[random() % soup.polygons.size()];
        switch (random() % 4) {
          case 0:
            std::reverse(polygon.begin(), polygon.end());
            break;
          case 1:
            polygon[0] = static_cast<int>(random() % soup.points.size());
            break;
          case 2:
            polygon = soup.polygons[random() % soup.polygons.size()];
            break;
          default:
            soup.points[polygon[1]] = soup.points[random() % soup.points.size()];
        }
      }
    }
    RepairOptions options;
    options.largest_hole = 0.8;
    try {
      const RepairedSurface result = repair(soup, "soup", options);
      ASSERT_TRUE(is_closed(result.mesh)) << round;
      ASSERT_GT(volume(result.mesh), 0) << round;
      ++closed;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(closed, 100);
  EXPECT_LT(closed, 600);
}

}  // namespace repair_test
}  // namespace toile
