#include "cloth/model/stretch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "cloth/model/compile.h"
#include "tests/cloth/panels.h"
#include "tests/support/stretch_energy.h"

namespace toile {
namespace stretch_test {

using Corners = std::array<Vec3, 3>;
using FlatCorners = std::array<Vec2, 3>;

/// The energy from the deformation gradient, computed in another way than stretch_forces() does. It
/// includes compression.
double energy(const FlatCorners& flat, double grain, const Fabric& fabric,
              const StretchOptions& options, const Corners& x,
              const LimitMultiplier& multiplier = {}) {
  Eigen::Matrix2d rest;
  rest << flat[1] - flat[0], flat[2] - flat[0];
  Eigen::Matrix<double, 3, 2> now;
  now << x[1] - x[0], x[2] - x[0];
  const Eigen::Matrix<double, 3, 2> gradient = now * rest.inverse();
  const Vec3 weft = gradient * (Eigen::Rotation2Dd(grain) * Vec2(1, 0));
  const Vec3 warp = gradient * (Eigen::Rotation2Dd(grain) * Vec2(0, 1));
  const auto beyond = [&](double stiffness, double by, double restraint) {
    const double stiffer = strain_limit_stiffening * stiffness;
    return stiffer * std::pow(std::max(by + restraint / stiffer, 0.0), 2);
  };
  const auto along = [&](double stiffness, double strain, double restraint) {
    const double own = stiffness * (strain < 0 ? options.compression : 1) * strain * strain;
    return options.limit < 0 ? own : own + beyond(stiffness, strain - options.limit, restraint);
  };
  const double turned = weft.dot(warp);
  double shear = fabric.shear * turned * turned;
  if (options.shear_limit >= 0) {
    shear += beyond(fabric.shear, turned - options.shear_limit, multiplier.shear) +
             beyond(fabric.shear, -turned - options.shear_limit, -multiplier.shear);
  }
  return 0.5 * 0.5 * rest.determinant() *
         (along(fabric.stretch_weft, weft.norm() - 1, multiplier.weft) +
          along(fabric.stretch_warp, warp.norm() - 1, multiplier.warp) + shear);
}

class Stretch : public testing::Test {
 protected:
  Stretch() {
    fabric.stretch_warp = 1500;
    fabric.stretch_weft = 700;
  }

  StretchTriangle compiled(const FlatCorners& flat, double grain) const {
    PanelMesh garment = test::flat_panel({{flat[0], flat[1], flat[2]}, {{0, 1, 2}}});
    garment.panels[0].grain = grain;
    Scene scene;
    scene.fabric = fabric;
    return compile(garment, scene, garment.placed).stretch[0];
  }

  Vec3 random_vector(double size) { return size * Vec3(unit(random), unit(random), unit(random)); }

  FlatCorners random_flat() {
    FlatCorners flat;
    do {
      for (Vec2& p : flat) p = 0.01 * Vec2(unit(random), unit(random));
    } while (area(flat) < 2e-5);
    return flat;
  }

  static double area(const FlatCorners& f) {
    const Vec2 a = f[1] - f[0], b = f[2] - f[0];
    return 0.5 * (a.x() * b.y() - a.y() * b.x());
  }

  /// Turned anyhow in space, each corner moved by up to `noise`.
  Corners random_place(const FlatCorners& flat, double noise) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random)).normalized();
    const Vec3 moved = random_vector(1);
    Corners x;
    for (int i = 0; i < 3; ++i) {
      x[i] = turn * Vec3(flat[i].x(), flat[i].y(), 0) + moved + random_vector(noise);
    }
    return x;
  }

  Fabric fabric;
  std::mt19937 random{7};
  std::uniform_real_distribution<double> unit{-1, 1};
};

TEST_F(Stretch, ForcesAreMinusTheGradientOfTheEnergy) {
  int compressed = 0, limited = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const FlatCorners flat = random_flat();
    const double grain = std::numbers::pi * unit(random);
    const StretchTriangle s = compiled(flat, grain);
    const Corners x = random_place(flat, 0.003);
    StretchOptions options;
    if (trial % 3 == 1) options.limit = 0.01;
    if (trial % 2 == 1) options.compression = 0.05;
    if (trial % 5 == 1) options.shear_limit = 0.05;
    LimitMultiplier multiplier;
    if (trial % 4 == 1) {
      multiplier = {100 * std::abs(unit(random)), 100 * std::abs(unit(random)), 20 * unit(random)};
    }
    const std::array<Vec3, 3> forces = stretch_forces(s, options, x[0], x[1], x[2], multiplier);
    double largest = 0;
    for (const Vec3& f : forces) largest = std::max(largest, f.norm());
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        const double h = 1e-8;
        Corners ahead = x, behind = x;
        ahead[corner][axis] += h;
        behind[corner][axis] -= h;
        const double slope = (energy(flat, grain, fabric, options, ahead, multiplier) -
                              energy(flat, grain, fabric, options, behind, multiplier)) /
                             (2 * h);
        ASSERT_NEAR(forces[corner][axis], -slope, 2e-5 * largest) << trial;
      }
    }
    const double with_limit = energy(flat, grain, fabric, options, x);
    if (options.compression == 1 && options.shear_limit < 0) {
      ASSERT_NEAR(stretch_energy(s, options.limit, x[0], x[1], x[2]), with_limit,
                  1e-9 * with_limit);
    }
    compressed += options.compression < 1 && with_limit < energy(flat, grain, fabric, {}, x);
    limited += options.limit >= 0 && with_limit > energy(flat, grain, fabric, {}, x);
  }
  EXPECT_GT(compressed, 50);
  EXPECT_GT(limited, 50);
}

TEST_F(Stretch, RigidMotionCostsNothing) {
  for (int trial = 0; trial < 50; ++trial) {
    const FlatCorners flat = random_flat();
    const StretchTriangle s = compiled(flat, unit(random));
    EXPECT_NEAR(s.area, area(flat), 1e-12 * s.area);
    const Corners x = random_place(flat, 0);
    EXPECT_LT(stretch_energy(s, 0, x[0], x[1], x[2]), 1e-20);
    for (const Vec3& f : stretch_forces(s, {}, x[0], x[1], x[2])) {
      EXPECT_LT(f.norm(), 1e-10);
    }
  }
}

TEST_F(Stretch, ForcesAddUpToNoForceAndNoTorque) {
  for (int trial = 0; trial < 100; ++trial) {
    const FlatCorners flat = random_flat();
    const Corners x = random_place(flat, 0.004);
    const auto forces = stretch_forces(compiled(flat, unit(random)), {0.01, 0.3}, x[0], x[1], x[2]);
    Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
    double size = 0;
    for (int i = 0; i < 3; ++i) {
      sum += forces[i];
      torque += (x[i] - x[0]).cross(forces[i]);
      size += forces[i].norm();
    }
    ASSERT_GT(size, 1e-3);
    EXPECT_LT(sum.norm(), 1e-12 * size);
    EXPECT_LT(torque.norm(), 1e-12 * size);
  }
}

TEST_F(Stretch, PureStretchCostsHalfStiffnessTimesStrainSquaredTimesArea) {
  const FlatCorners flat = {Vec2(0, 0), Vec2(0.02, 0), Vec2(0, 0.01)};
  const double strain = 0.03;
  // Along +y at no grain: warp. A quarter turn of the grain makes it weft.
  const Corners tall = {Vec3(0, 0, 0), Vec3(0.02, 0, 0), Vec3(0, 0.01 * (1 + strain), 0)};
  const double half = 0.5 * 1e-4 * strain * strain;
  EXPECT_NEAR(stretch_energy(compiled(flat, 0), -1, tall[0], tall[1], tall[2]),
              half * fabric.stretch_warp, 1e-12);
  EXPECT_NEAR(stretch_energy(compiled(flat, std::numbers::pi / 2), -1, tall[0], tall[1], tall[2]),
              half * fabric.stretch_weft, 1e-12);
  // The tension, per width, times the width of the middle line of the triangle.
  const auto forces = stretch_forces(compiled(flat, 0), {}, tall[0], tall[1], tall[2]);
  EXPECT_NEAR(forces[2].y(), -fabric.stretch_warp * strain * 0.01, 1e-9);
  EXPECT_NEAR(forces[2].x(), 0, 1e-12);
  EXPECT_NEAR(forces[0].y(), -forces[2].y(), 1e-9);
}

TEST_F(Stretch, ThreadsOnTheBiasFeelOnlyShear) {
  // Pulled by strain e along x with the grain at 45 degrees. Threads lengthen to sqrt((1 + (1 +
  // e)²) / 2) and meet at w_u · w_v = -+((1 + e)² - 1) / 2.
  const FlatCorners flat = {Vec2(0, 0), Vec2(0.01, 0), Vec2(0, 0.01)};
  const double e = 0.02;
  const double thread = std::sqrt((1 + (1 + e) * (1 + e)) / 2) - 1;
  const double shear = ((1 + e) * (1 + e) - 1) / 2;
  const Corners wide = {Vec3(0, 0, 0), Vec3(0.01 * (1 + e), 0, 0), Vec3(0, 0.01, 0)};
  EXPECT_NEAR(stretch_energy(compiled(flat, std::numbers::pi / 4), -1, wide[0], wide[1], wide[2]),
              0.5 * 5e-5 *
                  ((fabric.stretch_warp + fabric.stretch_weft) * thread * thread +
                   fabric.shear * shear * shear),
              1e-12);
}

TEST_F(Stretch, BeyondTheLimitClothIsAsMuchStiffer) {
  const FlatCorners flat = {Vec2(0, 0), Vec2(0.01, 0), Vec2(0, 0.01)};
  const StretchTriangle s = compiled(flat, 0);
  const auto pull = [&](double strain, double limit) {
    const Vec3 top(0, 0.01 * (1 + strain), 0);
    return -stretch_forces(s, {limit, 1}, Vec3::Zero(), Vec3(0.01, 0, 0), top)[2].y();
  };
  EXPECT_NEAR(pull(0.009, 0.01), pull(0.009, -1), 1e-12);
  EXPECT_NEAR(pull(0.02, 0.01) - pull(0.02, -1),
              strain_limit_stiffening * fabric.stretch_warp * 0.01 * 0.005, 1e-9);
}

TEST_F(Stretch, ATriangleCrushedToAPointGivesNumbers) {
  const StretchTriangle s = compiled({Vec2(0, 0), Vec2(0.01, 0), Vec2(0, 0.01)}, 0);
  for (const Vec3& f : stretch_forces(s, {0.01, 1}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero())) {
    EXPECT_TRUE(f.allFinite());
  }
}

}  // namespace stretch_test
}  // namespace toile
