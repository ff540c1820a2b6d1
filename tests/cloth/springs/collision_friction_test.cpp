#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "tests/cloth/springs/collision_scene.h"
#include "tests/support/shapes.h"

namespace toile {
namespace {

using test::LooseCloth;

// Reference case 6, incline: released at rest, or launched down the slope at 1 m/s.
struct InclineRow {
  double friction, slope_degrees;
  bool launched;
  double acceleration;   // m/s2; 0 when it sticks
  double stop_distance;  // m, when launched
};
constexpr InclineRow incline_rows[] = {
    {0, 5, false, 0.854997836354527, 0},
    {0, 10, false, 1.70348862291259, 0},
    {0, 15, false, 2.53901483245573, 0},
    {0, 20, false, 3.35521760602481, 0},
    {0, 30, false, 4.905, 0},
    {0, 45, false, 6.93671752344003, 0},
    {0.1, 5, false, 0, 0},
    {0.1, 5.61059313749964, false, 0, 0},
    {0.1, 5.81059313749964, false, 0.0172070666683815, 0},
    {0.1, 10, false, 0.737392217207611, 0},
    {0.1, 15, false, 1.59144159686615, 0},
    {0.1, 20, false, 2.43337914503383, 0},
    {0.1, 30, false, 4.05542907888746, 0},
    {0.1, 45, false, 6.24304577109603, 0},
    {0.3, 5, false, 0, 0},
    {0.3, 5, true, -2.07680316012948, 0.240754641363713},
    {0.3, 10, false, 0, 0},
    {0.3, 10, true, -1.19480059420234, 0.418479872228222},
    {0.3, 15, false, 0, 0},
    {0.3, 16.5992442339936, false, 0, 0},
    {0.3, 16.7992442339936, false, 0.0178755495997994, 0},
    {0.3, 20, false, 0.589702223051882, 0},
    {0.3, 30, false, 2.3562872366624, 0},
    {0.3, 45, false, 4.85570226640802, 0},
    {0.5, 5, false, 0, 0},
    {0.5, 5, true, -4.03133715778549, 0.124028326193055},
    {0.5, 10, false, 0, 0},
    {0.5, 10, true, -3.12699340561229, 0.15989800269569},
    {0.5, 15, false, 0, 0},
    {0.5, 15, true, -2.19885134549215, 0.227391451916495},
    {0.5, 20, false, 0, 0},
    {0.5, 20, true, -1.25397469893007, 0.398732127870375},
    {0.5, 26.465051177078, false, 0, 0},
    {0.5, 26.665051177078, false, 0.0191426104234619, 0},
    {0.5, 30, false, 0.657145394437328, 0},
    {0.5, 45, false, 3.46835876172001, 0},
    {0.8, 5, false, 0, 0},
    {0.8, 5, true, -6.96313815426949, 0.0718067039490552},
    {0.8, 10, false, 0, 0},
    {0.8, 10, true, -6.02528262272722, 0.0829836592418108},
    {0.8, 15, false, 0, 0},
    {0.8, 15, true, -5.04157105226088, 0.0991754345653378},
    {0.8, 20, false, 0, 0},
    {0.8, 20, true, -4.019490081903, 0.124393888232529},
    {0.8, 30, false, 0, 0},
    {0.8, 30, true, -1.89156736890028, 0.264331055938384},
    {0.8, 38.5598082540901, false, 0, 0},
    {0.8, 38.7598082540901, false, 0.0219264376581713, 0},
    {0.8, 45, false, 1.387343504688, 0},
};

/// The slope as a level plane under gravity that leans, and a small sheet at the gap above it.
LooseCloth on_a_slope(double friction) {
  LooseCloth cloth(test::box({-1, -0.1, -1}, {5, 0, 1}), test::level_sheet(1, 1, 0.02, 0.002),
                   Vec3::Zero());
  cloth.options.friction = friction;
  return cloth;
}

Vec3 leaning_gravity(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return 9.81 * Vec3(std::sin(angle), -std::cos(angle), 0);
}

TEST(CollisionFriction, SticksBelowTheConeAndSlidesAboveIt) {
  constexpr double dt = 2e-4;
  constexpr int steps = 1000;
  double creep = 0;
  double error = 0;
  for (const InclineRow& row : incline_rows) {
    if (row.launched) continue;
    LooseCloth cloth = on_a_slope(row.friction);
    const double start = cloth.x[0].x();
    for (int i = 0; i < steps; ++i) cloth.step(dt, leaning_gravity(row.slope_degrees));
    const double time = steps * dt;
    if (row.acceleration == 0) {
      creep = std::max(creep, std::abs(cloth.x[0].x() - start) / time);
      creep = std::max(creep, cloth.v[0].norm());
    } else {
      error = std::max(error, std::abs(cloth.v[0].x() / time / row.acceleration - 1));
    }
    EXPECT_NEAR(cloth.x[0].y(), 0.002, 1e-9);
  }
  EXPECT_LT(creep, 1e-9);
  EXPECT_LT(error, 1e-6);
  std::cout << "creep " << creep << " m/s, relative error of the acceleration " << error << '\n';
}

TEST(CollisionFriction, ALaunchedSheetStopsWhereItShould) {
  constexpr double dt = 5e-4;
  double error = 0;
  double creep = 0;
  for (const InclineRow& row : incline_rows) {
    if (!row.launched) continue;
    LooseCloth cloth = on_a_slope(row.friction);
    const double start = cloth.x[0].x();
    for (Vec3& v : cloth.v) v.x() = 1;
    const int steps = static_cast<int>((2 * row.stop_distance + 0.05) / dt);
    for (int i = 0; i < steps; ++i) cloth.step(dt, leaning_gravity(row.slope_degrees));
    error = std::max(error, std::abs((cloth.x[0].x() - start) / row.stop_distance - 1));
    creep = std::max(creep, cloth.v[0].norm());
  }
  EXPECT_LT(error, 0.01);
  EXPECT_LT(creep, 1e-9);
  std::cout << "relative error of the stop distance at dt " << dt << " s: " << error << ", creep "
            << creep << " m/s\n";
}

TEST(CollisionFriction, ADryOscillatorLosesAsMuchEachHalfCycle) {
  // Reference case 6, dry oscillator: m = 0.01 kg, k = 1 N/m, mu = 0.2; turning points, metres.
  constexpr double turning[] = {0.2, -0.16076, 0.12152, -0.08228, 0.04304, -0.0038};
  constexpr double dt = 1e-4;
  LooseCloth cloth = on_a_slope(0.2);
  const std::vector<Vec3> rest = cloth.x;
  for (Vec3& p : cloth.x) p.x() += turning[0];
  double error = 0;
  double before = 0;
  int half_cycles = 0;
  for (int i = 0; i < 20000; ++i) {
    for (std::size_t k = 0; k < rest.size(); ++k) {
      cloth.v[k].x() -= dt * (1 / 0.01) * (cloth.x[k].x() - rest[k].x());
    }
    cloth.step(dt, Vec3(0, -9.81, 0));
    const double now = cloth.v[0].x();
    if (i > 0 && before * now <= 0 && before != 0) {
      ++half_cycles;
      ASSERT_LT(half_cycles, 6);
      error = std::max(error, std::abs(cloth.x[0].x() - rest[0].x() - turning[half_cycles]));
    }
    before = now;
  }
  EXPECT_EQ(half_cycles, 5);
  EXPECT_LT(error, 2e-4);
  EXPECT_EQ(cloth.v[0].x(), 0);
  std::cout << "largest error of a turning point " << error << " m\n";
}

TEST(CollisionFriction, TheImpulseStaysInTheCone) {
  // One step of a fast oblique impact: what friction takes is mu times what the surface gave.
  LooseCloth cloth = on_a_slope(0.4);
  for (Vec3& v : cloth.v) v = Vec3(3, -2, 1);
  cloth.options.restitution = 0.5;
  cloth.step(1e-4, Vec3::Zero());
  const Vec3 change = cloth.v[0] - Vec3(3, -2, 1);
  EXPECT_NEAR(change.y(), 3, 1e-12);
  EXPECT_NEAR(std::hypot(change.x(), change.z()), 0.4 * 3, 1e-12);
  EXPECT_NEAR(change.x() / change.z(), 3, 1e-12);
  // A slow slide is stopped, not turned around.
  for (Vec3& v : cloth.v) v = Vec3(0.3, -2, 0.1);
  for (Vec3& p : cloth.x) p.y() = 0.002;
  cloth.step(1e-4, Vec3::Zero());
  EXPECT_NEAR(std::hypot(cloth.v[0].x(), cloth.v[0].z()), 0, 1e-12);
}

}  // namespace
}  // namespace toile
