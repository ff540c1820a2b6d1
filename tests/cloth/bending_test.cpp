// The hinges of a program against the bending energy of a plate.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "cloth/program.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace {

double bend_energy(const Program& program, const std::vector<Vec3>& points) {
  double energy = 0;
  for (const BendHinge& hinge : program.bend) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 4; ++i) sum += hinge.weights[i] * points[hinge.points[i]];
    energy += 0.5 * hinge.stiffness * sum.squaredNorm();
  }
  return energy;
}

/// Energy of the mesh, rolled up around an axis at `angle` to its +y, as a share of ½ B A / R².
double rolled(const PlanarMesh& mesh, double radius, double angle, const Fabric& fabric = {},
              double grain = 0) {
  PanelMesh garment = test::flat_panel(mesh);
  garment.panels[0].grain = grain;
  Scene scene;
  scene.fabric = fabric;
  const Program program = compile(garment, scene, garment.placed);
  const Eigen::Rotation2Dd turn(-angle);
  std::vector<Vec3> points;
  double area = 0;
  for (const Vec2& p : garment.flat) {
    const Vec2 q = turn * p;
    const double around = q.x() / radius;
    points.emplace_back(radius * std::sin(around), q.y(), radius * std::cos(around));
  }
  for (const StretchTriangle& s : program.stretch) area += s.area;
  return bend_energy(program, points) /
         (0.5 * program.scene.fabric.bending_weft * area / (radius * radius));
}

/// Squares of 40 cm: one cut regularly, one as mesh_polygon does.
PlanarMesh unstructured() {
  std::vector<Vec2> border;
  for (int i = 0; i < 40; ++i) border.emplace_back(0.01 * i, 0);
  for (int i = 0; i < 40; ++i) border.emplace_back(0.4, 0.01 * i);
  for (int i = 0; i < 40; ++i) border.emplace_back(0.4 - 0.01 * i, 0.4);
  for (int i = 0; i < 40; ++i) border.emplace_back(0, 0.4 - 0.01 * i);
  return mesh_polygon(border, 0.01);
}

TEST(Bend, ARolledSheetHasThePlatesEnergy) {
  // Hinges miss the sheet's border, 2.5 % of its area.
  const PlanarMesh mesh = unstructured();
  for (const double degrees : {0, 15, 30, 45, 60, 90, 135}) {
    for (const double radius : {0.1, 0.2, 0.5}) {
      EXPECT_NEAR(rolled(mesh, radius, degrees * std::numbers::pi / 180), 0.99, 0.03) << degrees;
    }
  }
}

TEST(Bend, ARegularGridHasItAlongItsEdges) {
  // Right-angled triangles all cut one way are known to favour directions: rolled along a thread or
  // along the diagonal they agree with the plate; across the diagonals they are stiffer.
  const PlanarMesh mesh = test::grid(0.4, 0.4, 40, 40);
  for (const double degrees : {0, 90, 135}) {
    EXPECT_NEAR(rolled(mesh, 0.2, degrees * std::numbers::pi / 180), 0.985, 0.02) << degrees;
  }
}

}  // namespace
}  // namespace toile
