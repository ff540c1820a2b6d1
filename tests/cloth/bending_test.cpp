// The hinges of a program against the bending energy of a plate.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "cloth/hinge_rigidity.h"
#include "cloth/program.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace {

constexpr double pi = std::numbers::pi;

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

// Rolled so that the threads of one kind bend, the other's rigidity does not count, as nearly as
// hinges can have it. Rolled on the bias, the sheet's rigidity is between the two; where between
// depends on how the edges lie to the threads.
TEST(Bend, WarpAndWeftBendByTheirOwnRigidity) {
  const PlanarMesh mesh = unstructured();
  for (const double ratio : {0.12, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 8.0}) {
    Fabric fabric;
    fabric.bending_weft = 1e-5;
    fabric.bending_warp = ratio * 1e-5;
    double worst = 0;
    double least_bias = 1e9, most_bias = 0;
    for (const double grain : {0.0, 0.3, pi / 4, 1.0, pi / 2}) {
      const double weft = rolled(mesh, 0.2, grain, fabric, grain);
      const double warp = rolled(mesh, 0.2, grain + pi / 2, fabric, grain) / ratio;
      worst = std::max({worst, std::abs(weft - 0.985), std::abs(warp - 0.985)});
      const double bias = rolled(mesh, 0.2, grain + pi / 4, fabric, grain);
      least_bias = std::min(least_bias, bias);
      most_bias = std::max(most_bias, bias);
    }
    std::cout << "warp " << ratio << " times as rigid as weft: off by up to " << 100 * worst
              << " %; on the bias " << least_bias << " to " << most_bias << " of the weft's, plate "
              << bending_along(fabric, pi / 4) / fabric.bending_weft << "\n";
    const bool is_moderate = std::max(ratio, 1 / ratio) <= 3;
    EXPECT_LT(worst, ratio == 1 ? 0.02 : is_moderate ? 0.06 : 0.14);
    EXPECT_GT(least_bias, 0.97 * std::min(ratio, 1.0));
    EXPECT_LT(most_bias, 1.03 * std::max(ratio, 1.0));
  }
}

}  // namespace
}  // namespace toile
