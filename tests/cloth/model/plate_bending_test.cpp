// What bends in a model against the bending energy of a plate.
#include "cloth/model/plate_bending.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <random>

#include "cloth/model/compile.h"
#include "cloth/model/constants.h"
#include "tests/cloth/bend_energy.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace plate_bending_test {

constexpr double pi = std::numbers::pi;

/// Energy of the mesh, rolled up around an axis at `angle` to its +y, as a share of ½ B A / R².
double rolled(const PlanarMesh& mesh, double radius, double angle, const Fabric& fabric = {},
              double grain = 0) {
  PanelMesh garment = test::flat_panel(mesh);
  garment.panels[0].grain = grain;
  Scene scene;
  scene.fabric = fabric;
  const GarmentModel model = compile(garment, scene, garment.placed);
  const Eigen::Rotation2Dd turn(-angle);
  std::vector<Vec3> points;
  double area = 0;
  for (const Vec2& p : garment.flat) {
    const Vec2 q = turn * p;
    const double around = q.x() / radius;
    points.emplace_back(radius * std::sin(around), q.y(), radius * std::cos(around));
  }
  for (const StretchTriangle& s : model.stretch) area += s.area;
  return test::bend_energy(model, points) /
         (0.5 * model.scene.fabric.bending_weft * area / (radius * radius));
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

// At the border the jumps of one edge or two tell of a curvature that takes less: up to 3 %.
TEST(PlateBending, ARolledSheetHasThePlatesEnergyHoweverItIsCut) {
  for (const PlanarMesh& mesh : {unstructured(), test::grid(0.4, 0.4, 40, 40)}) {
    for (const double degrees : {0, 15, 30, 45, 60, 90, 135}) {
      for (const double radius : {0.1, 0.2, 0.5}) {
        EXPECT_NEAR(rolled(mesh, radius, degrees * pi / 180), 0.985, 0.015) << degrees;
      }
    }
  }
}

// If the sheet is rolled so that the threads of one kind bend, the rigidity of the other kind does
// not count. On the bias it has the rigidity of an orthotropic plate, in whatever direction the
// threads run through the mesh.
TEST(PlateBending, WarpAndWeftBendByTheirOwnRigidity) {
  const PlanarMesh mesh = unstructured();
  for (const double ratio : {0.01, 0.12, 0.5, 1.0, 3.0, 8.0, 100.0}) {
    Fabric fabric;
    fabric.bending_weft = 1e-5;
    fabric.bending_warp = ratio * 1e-5;
    double worst = 0;
    for (const double grain : {0.0, 0.3, pi / 4, 1.0, pi / 2}) {
      for (const double direction : {0.0, pi / 4, pi / 2, 2.5}) {
        const double plate = bending_along(fabric, direction) / fabric.bending_weft;
        const double share = rolled(mesh, 0.2, grain + direction, fabric, grain) / plate;
        worst = std::max(worst, std::abs(share - 1));
      }
    }
    std::cout << "warp " << ratio << " times as rigid as weft: off by up to " << 100 * worst
              << " %\n";
    EXPECT_LT(worst, std::max(ratio, 1 / ratio) < 10 ? 0.03 : 0.04);
  }
}

// Seen from either side, across a seam the sheet goes on, rolled askew to it.
TEST(PlateBending, ASewnSheetBendsAsIfItWereNotCut) {
  PanelMesh sewn;
  const PlanarMesh half = test::grid(0.1, 0.1, 10, 10);
  for (const double shift : {0.0, 0.1}) {
    test::add_panel(sewn, "half", half, [&](const Vec2& p) {
      const Vec2 q = Eigen::Rotation2Dd(0.5) * Vec2(p.x() + shift, p.y());
      return Vec3(0.2 * std::sin(5 * q.x()), q.y(), 0.2 * std::cos(5 * q.x()));
    });
  }
  PanelMesh whole = test::flat_panel(test::grid(0.2, 0.1, 20, 10));
  for (std::size_t p = 0; p < whole.flat.size(); ++p) {
    for (std::size_t q = 0; q < sewn.flat.size(); ++q) {
      const Vec2 shift(q < half.points.size() ? 0 : 0.1, 0);
      if ((sewn.flat[q] + shift - whole.flat[p]).norm() < 1e-9) whole.placed[p] = sewn.placed[q];
    }
  }
  sewn.seams = {test::seam("middle", test::side(sewn.panels[0], 10, 10, true),
                           test::side(sewn.panels[1], 10, 10, false))};
  Scene scene;
  scene.fabric.bending_warp = 3e-5;
  const double cut = test::bend_energy(compile(sewn, scene, sewn.placed), sewn.placed);
  const double uncut = test::bend_energy(compile(whole, scene, whole.placed), whole.placed);
  EXPECT_NEAR(cut, uncut, 1e-9 * uncut);
}

std::array<Vec3, 3> random_jumps(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::array<Vec3, 3> jumps;
  for (Vec3& jump : jumps) jump = 0.01 * Vec3(unit(random), unit(random), unit(random));
  return jumps;
}

TEST(PlateBending, ATriangleHasThePlatesEnergyAtEveryCurvature) {
  std::mt19937 random(3);
  Fabric fabric;
  fabric.bending_weft = 3e-5;
  fabric.bending_warp = 1e-5;
  const Vec3 plate(3e-5, 1e-5, 2 * std::sqrt(3e-10));
  for (int trial = 0; trial < 100; ++trial) {
    const std::array<Vec3, 3> jumps = random_jumps(random);
    const Eigen::Matrix3d stiffness = plate_stiffness(fabric, 2e-4, jumps, {true, true, true});
    const Eigen::Matrix3d missing = plate_stiffness(fabric, 2e-4, jumps, {true, false, true});
    for (const Vec3& curvature : random_jumps(random)) {
      Vec3 jump;
      for (int i = 0; i < 3; ++i) jump[i] = jumps[i].dot(curvature);
      const double energy = 2e-4 * curvature.dot(plate.cwiseProduct(curvature));
      EXPECT_LE(jump.dot(stiffness * jump), energy * (1 + 1e-9));
      EXPECT_LE(jump.dot(missing * jump), energy * (1 + 1e-9));
      Eigen::Matrix3d rows;
      for (int i = 0; i < 3; ++i) rows.row(i) = jumps[i].normalized();
      const double distinct =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rows * rows.transpose()).eigenvalues()[0];
      if (distinct < min_distinct_jumps) continue;
      EXPECT_NEAR(jump.dot(stiffness * jump), energy, 1e-9 * energy);
    }
    EXPECT_EQ(missing.row(1), Vec3::Zero().transpose());
    EXPECT_EQ(missing.col(1), Vec3::Zero());
    for (const Eigen::Matrix3d& matrix : {stiffness, missing}) {
      EXPECT_EQ(matrix, matrix.transpose());
      const Vec3 values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvalues();
      EXPECT_GE(values.minCoeff(), -1e-12 * values.maxCoeff());
    }
  }
}

// Without a bound, corners on one conic would be stiff beyond measure, and steps as short.
TEST(PlateBending, EdgesThatDoNotTellCurvaturesApartAreBounded) {
  Fabric fabric;
  const Vec3 across(0.01, 0, 0), twisted(0, 0.01, 0);
  const Eigen::Matrix3d stiffness =
      plate_stiffness(fabric, 1e-4, {across, twisted, across + twisted}, {true, true, true});
  // On its own the first has 1e-4 m² · 1e-5 N·m / (1 cm)².
  EXPECT_TRUE(stiffness.allFinite());
  EXPECT_LE(stiffness.norm(), 1e-5 * 2 / min_distinct_jumps);
  EXPECT_EQ(plate_stiffness(fabric, 1e-4, {across, twisted, across}, {false, false, false}).norm(),
            0);
}

// The jump of a sheet bent a little, against that of its flat neighbours.
TEST(PlateBending, JumpsAreThoseOfABentSheet) {
  const Vec2 a(0.01, 0.02), b(0.03, 0.01), c(0.03, 0.04), d(0.015, -0.01);
  const double grain = 0.4;
  const Vec2 along = (b - a).normalized();
  const Vec2 normal(-along.y(), along.x());
  const Vec2 weft(std::cos(grain), std::sin(grain)), warp(-weft.y(), weft.x());
  const Vec3 felt = jump_by_curvature(a, b, c, {along.dot(d - a), -normal.dot(d - a)}, grain);
  const Vec3 curvature(0.3, -0.7, 0.9);
  const auto height = [&](const Vec2& p) {
    const double u = weft.dot(p), v = warp.dot(p);
    return 0.5 * curvature[0] * u * u + 0.5 * curvature[1] * v * v + curvature[2] * u * v;
  };
  // Slope square to the edge of the plane through a, b and a corner.
  const auto slope = [&](const Vec2& corner) {
    Eigen::Matrix2d sides;
    sides << (b - a).transpose(), (corner - a).transpose();
    const Vec2 gradient = sides.inverse() * Vec2(height(b) - height(a), height(corner) - height(a));
    return gradient.dot(normal);
  };
  EXPECT_NEAR(felt.dot(curvature), slope(c) - slope(d), 1e-12);
}

}  // namespace plate_bending_test
}  // namespace toile
