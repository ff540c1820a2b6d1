#include "geometry/mesh_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "geometry/angles.h"
#include "geometry/polygon.h"
#include "geometry/triangulate.h"

namespace toile {
namespace mesh_polygon_test {

/// The polygon with its sides cut into steps of about `step`.
std::vector<Vec2> cut(const std::vector<Vec2>& corners, double step) {
  std::vector<Vec2> outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 run = corners[(i + 1) % corners.size()] - corners[i];
    const int steps = std::max(1, static_cast<int>(std::lround(run.norm() / step)));
    for (int k = 0; k < steps; ++k) outline.push_back(corners[i] + run * k / steps);
  }
  return outline;
}

/// Triangle edges that run from border to border without being part of it.
int crossings(const PlanarMesh& mesh, int border) {
  std::map<std::array<int, 2>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = std::min(t[k], t[(k + 1) % 3]);
      const int b = std::max(t[k], t[(k + 1) % 3]);
      if (b < border) ++edges[{a, b}];
    }
  }
  int count = 0;
  for (const auto& [edge, triangles] : edges) count += triangles == 2;
  return count;
}

TEST(MeshPolygon, ARectangleIsNearlyHexagonal) {
  const std::vector<Vec2> outline = cut({{0, 0}, {0.6, 0}, {0.6, 0.4}, {0, 0.4}}, 0.02);
  const PlanarMesh mesh = mesh_polygon(outline, 0.02);
  for (std::size_t i = 0; i < outline.size(); ++i) EXPECT_EQ(mesh.points[i], outline[i]);
  EXPECT_EQ(mesh.triangles.size(), 2 * mesh.points.size() - outline.size() - 2);
  EXPECT_GT(smallest_angle(mesh.points, mesh.triangles), to_radians(30));
  // Hexagonal cells of side h take sqrt(3)/2 h^2 of area each.
  const double expected = 0.24 / (std::sqrt(3.0) / 2 * 0.02 * 0.02);
  EXPECT_NEAR(static_cast<double>(mesh.points.size()), expected, 0.15 * expected);
  EXPECT_EQ(crossings(mesh, static_cast<int>(outline.size())), 0);
}

TEST(MeshPolygon, GradesTowardShortSegments) {
  // One corner is cut off by a segment a tenth of the others.
  std::vector<Vec2> outline = cut({{0, 0}, {0.4, 0}, {0.4, 0.4}, {0, 0.4}}, 0.04);
  outline[0] = {0.0028, 0};
  outline.insert(outline.begin(), Vec2(0, 0.0028));
  const PlanarMesh mesh = mesh_polygon(outline, 0.04);
  EXPECT_GT(smallest_angle(mesh.points, mesh.triangles), to_radians(12));
}

TEST(MeshPolygon, SurvivesSharpCornersThinStripsAndCoarseLengths) {
  const std::vector<std::vector<Vec2>> shapes = {
      cut({{0, 0}, {0.5, 0}, {0.5, 0.05}}, 0.02),
      cut({{0, 0}, {0.5, 0}, {0.5, 0.004}, {0, 0.004}}, 0.02),
      cut({{0, 0}, {0.4, 0}, {0.4, 0.3}, {0.205, 0.3}, {0.2, 0.1}, {0.195, 0.3}, {0, 0.3}}, 0.02),
      {{0, 0}, {1, 0}, {0, 1}},
  };
  for (const std::vector<Vec2>& outline : shapes) {
    for (const double edge_length : {0.015, 0.1, 5.0}) {
      const PlanarMesh mesh = mesh_polygon(outline, edge_length);
      EXPECT_EQ(mesh.triangles.size(), 2 * mesh.points.size() - outline.size() - 2);
      EXPECT_GT(smallest_angle(mesh.points, mesh.triangles), 0);
      for (std::size_t i = outline.size(); i < mesh.points.size(); ++i) {
        EXPECT_TRUE(inside(outline, mesh.points[i]));
      }
    }
  }
}

TEST(MeshPolygon, HolesStayEmptyAndKeepTheirPoints) {
  const std::vector<Vec2> outline = cut({{0, 0}, {0.6, 0}, {0.6, 0.4}, {0, 0.4}}, 0.02);
  const std::vector<std::vector<Vec2>> holes = {
      cut({{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.3}, {0.1, 0.3}}, 0.02),
      cut({{0.4, 0.3}, {0.5, 0.3}, {0.45, 0.1}}, 0.01)};
  const PlanarMesh mesh = mesh_polygon(outline, 0.02, {}, holes);
  std::size_t point = outline.size();
  for (const std::vector<Vec2>& hole : holes) {
    for (const Vec2& p : hole) EXPECT_EQ(mesh.points[point++], p);
  }
  for (const Triangle& t : mesh.triangles) {
    const Vec2 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    for (const std::vector<Vec2>& hole : holes) EXPECT_FALSE(inside(hole, middle));
  }
  EXPECT_EQ(mesh.triangles.size(), 2 * mesh.points.size() - point - 2 + 4);
  EXPECT_GT(smallest_angle(mesh.points, mesh.triangles), to_radians(20));
}

TEST(MeshPolygon, RaisingAnglesMovesOnlyWhatMayMove) {
  PlanarMesh mesh{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.05}},
                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  const PlanarMesh before = mesh;
  raise_angles(mesh, {true, true, true, true, true}, to_radians(40));
  EXPECT_EQ(mesh.points, before.points);
  raise_angles(mesh, {true, true, true, true, false}, to_radians(44));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh.points[i], before.points[i]);
  // With the free point in the middle of the square, its triangles have angles of 45 degrees.
  EXPECT_GT(smallest_angle(mesh.points, mesh.triangles), to_radians(35));
}

}  // namespace mesh_polygon_test
}  // namespace toile
