// Garments and bodies of known gaps: tubes around the y axis, spheres.
#pragma once

#include <cmath>
#include <numbers>

#include "pattern/file/garment_file.h"
#include "tests/support/shapes.h"

namespace toile::test {

/// A closed cylinder from y = 0 to `height` with `around` sides. Its corners lie on the ellipse of
/// half axes a (x) and b (z), and each end has a point in its middle.
inline TriangleMesh closed_tube(double a, double b, double height, int around) {
  TriangleMesh mesh;
  for (const double y : {0.0, height}) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      mesh.points.emplace_back(a * std::sin(angle), y, b * std::cos(angle));
    }
  }
  mesh.points.emplace_back(0, 0, 0);
  mesh.points.emplace_back(0, height, 0);
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    mesh.triangles.push_back({i, j, around + j});
    mesh.triangles.push_back({i, around + j, around + i});
    mesh.triangles.push_back({j, i, 2 * around});
    mesh.triangles.push_back({around + i, around + j, 2 * around + 1});
  }
  return mesh;
}

/// An open tube of cloth from y = `low` to `high` in `rows` rows. A half "front" (z > 0) and a half
/// "back" are sewn together at the sides, so their points there share nodes. `around` has to be
/// even.
inline DressedGarment cloth_tube(double a, double b, double low, double high, int around,
                                 int rows) {
  DressedGarment garment;
  garment.panels = {"front", "back"};
  const int half = around / 2;
  const auto node = [&](int i, int row) { return row * around + i % around; };
  for (int row = 0; row <= rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const double angle = std::numbers::pi * (2.0 * i / around - 0.5);
      garment.points.emplace_back(a * std::sin(angle), low + (high - low) * row / rows,
                                  b * std::cos(angle));
    }
  }
  for (int panel = 0; panel < 2; ++panel) {
    const int first = static_cast<int>(garment.flat.size());
    for (int row = 0; row <= rows; ++row) {
      for (int i = 0; i <= half; ++i) garment.flat.emplace_back(0.01 * i, 0.01 * row);
    }
    const auto flat = [&](int i, int row) { return first + row * (half + 1) + i; };
    for (int row = 0; row < rows; ++row) {
      for (int i = 0; i < half; ++i) {
        const int from = panel * half + i;
        garment.triangles.push_back(
            {node(from, row), node(from + 1, row), node(from + 1, row + 1)});
        garment.flat_triangles.push_back({flat(i, row), flat(i + 1, row), flat(i + 1, row + 1)});
        garment.triangles.push_back(
            {node(from, row), node(from + 1, row + 1), node(from, row + 1)});
        garment.flat_triangles.push_back({flat(i, row), flat(i + 1, row + 1), flat(i, row + 1)});
        garment.panel_of_triangle.insert(garment.panel_of_triangle.end(), 2, panel);
      }
    }
  }
  return garment;
}

/// A whole sphere as a garment of one panel.
inline DressedGarment sphere_garment(double radius, int levels) {
  DressedGarment garment;
  const TriangleMesh ball = sphere(radius, levels);
  garment.points = ball.points;
  garment.triangles = ball.triangles;
  garment.flat.assign(ball.points.size(), Vec2::Zero());
  garment.flat_triangles = ball.triangles;
  garment.panels = {"ball"};
  garment.panel_of_triangle.assign(ball.triangles.size(), 0);
  return garment;
}

}  // namespace toile::test
