// Coulomb's friction of the paper's impulses: sheets on a slope [reference case 6].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/cloth/springs/collision_scene.h"
#include "tests/support/shapes.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"

namespace toile {
namespace springs_friction_test {

using test::LooseCloth;

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
  const test::ReferenceTable table("case06_incline.csv");
  double creep = 0;
  double error = 0;
  int stuck = 0;
  int slid = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, "set") != "release") continue;
    LooseCloth cloth = on_a_slope(table.at(row, "mu"));
    const double start = cloth.x[0].x();
    const Vec3 gravity = leaning_gravity(table.at(row, "slope_deg"));
    for (int i = 0; i < steps; ++i) cloth.step(dt, gravity);
    const double time = steps * dt;
    if (table.text(row, "state") == "stick") {
      ++stuck;
      creep = std::max(creep, std::abs(cloth.x[0].x() - start) / time);
      creep = std::max(creep, cloth.v[0].norm());
    } else {
      ++slid;
      const double acceleration = table.at(row, "acceleration_m_s2");
      error = std::max(error, std::abs(cloth.v[0].x() / time / acceleration - 1));
    }
    EXPECT_NEAR(cloth.x[0].y(), 0.002, 1e-9);
  }
  ASSERT_GT(std::min(stuck, slid), 15);
  test::expect_near({"slopes below the friction angle, by 0.1 degrees and more: creep", "springs",
                     "step 0.2 ms", "um/s"},
                    1e6 * creep, 0, 1e-3);
  test::expect_near({"slopes beyond the friction angle, by 0.1 degrees and more: acceleration",
                     "springs", "step 0.2 ms, worst of " + std::to_string(slid), "%"},
                    100 * error, 0, 1e-4);
}

TEST(CollisionFriction, ALaunchedSheetStopsWhereItShould) {
  constexpr double dt = 5e-4;
  const test::ReferenceTable table("case06_incline.csv");
  double error = 0;
  double creep = 0;
  int launched = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double distance = table.at(row, "stop_distance_m");
    // Others slide off the slope's end, or nearly for ever.
    if (!(distance > 0 && distance < 0.6)) continue;
    ++launched;
    LooseCloth cloth = on_a_slope(table.at(row, "mu"));
    const double start = cloth.x[0].x();
    for (Vec3& v : cloth.v) v.x() = 1;
    const Vec3 gravity = leaning_gravity(table.at(row, "slope_deg"));
    const int steps = static_cast<int>((2 * distance + 0.05) / dt);
    for (int i = 0; i < steps; ++i) cloth.step(dt, gravity);
    error = std::max(error, std::abs((cloth.x[0].x() - start) / distance - 1));
    creep = std::max(creep, cloth.v[0].norm());
  }
  ASSERT_GT(launched, 10);
  test::expect_near({"launched down a slope: way until it stops", "springs",
                     "step 0.5 ms, worst of " + std::to_string(launched), "%"},
                    100 * error, 0, 1);
  EXPECT_LT(creep, 1e-9);
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
  test::expect_near({"dry oscillator: turning points", "springs", "step 0.1 ms", "mm"},
                    1000 * error, 0, 0.2);
  EXPECT_EQ(cloth.v[0].x(), 0);
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

}  // namespace springs_friction_test
}  // namespace toile
