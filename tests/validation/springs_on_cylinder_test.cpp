// Springs drawn around a cylinder: the pressure of a tube that is too small, the friction of a
// strip.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth/springs/spring_forces.h"
#include "cloth/springs/subject_collisions.h"
#include "tests/support/tubes.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"

namespace toile {
namespace springs_on_cylinder_test {

constexpr double gap = 0.002;
constexpr double pi = std::numbers::pi;

/// Cloth of springs against a cylinder around the y axis, its nodes `gap` off it.
struct Wrapped {
  std::vector<Vec3> x;
  std::vector<Vec3> v;
  std::vector<double> inverse_mass;
  std::vector<Spring> springs;
  std::vector<Triangle> triangles;
  std::vector<Vec3> pull;  // N, from outside
  CollisionOptions options;

  explicit Wrapped(const std::vector<Vec3>& points, double mass)
      : x(points),
        v(points.size(), Vec3::Zero()),
        inverse_mass(points.size(), 1 / mass),
        pull(points.size(), Vec3::Zero()) {}

  /// Moves for `seconds`; returns the mean of the collisions' radial force, N.
  template <typename EachStep>
  double run(double radius, double seconds, double drag, const EachStep& each_step) {
    SubjectCollisions collisions(test::closed_tube(radius - gap, radius - gap, 0.3, 512),
                                 triangles);
    const SpringForces forces(springs, static_cast<int>(x.size()));
    const double dt = 0.5 * stable_step(springs, inverse_mass, drag);
    const int steps = static_cast<int>(seconds / dt);
    double impulse = 0;
    int counted = 0;
    for (int step = 0; step < steps; ++step) {
      each_step(step * dt);
      std::vector<Vec3> force = pull;
      forces.add(x, v, force);
      for (std::size_t n = 0; n < x.size(); ++n) {
        v[n] = (v[n] + dt * inverse_mass[n] * force[n]) / (1 + dt * drag);
      }
      const std::vector<Vec3> before = v;
      collisions.respond(x, inverse_mass, dt, options, v);
      if (step > steps / 2) {
        ++counted;
        for (std::size_t n = 0; n < x.size(); ++n) {
          const Vec3 outward = Vec3(x[n].x(), 0, x[n].z()).normalized();
          impulse += outward.dot(v[n] - before[n]) / inverse_mass[n];
        }
      }
      for (std::size_t n = 0; n < x.size(); ++n) x[n] += dt * v[n];
    }
    return impulse / (counted * dt);
  }
};

// Reference case 8, a polygon of 64 nodes on R = 0.15 m at 5 % and Y = 500 N/m. Its strain is
// 0.0495783758 and its pressure 165.2612527 Pa, 8.4e-3 below that of the round tube.
TEST(WrappedCylinder, ATooSmallTubePressesAsLaplaceSays) {
  constexpr double radius = 0.15;
  constexpr double stiffness = 500;
  constexpr int around = 64;
  constexpr int rows = 4;
  constexpr double height = 0.04;
  const DressedGarment tube = test::cloth_tube(radius, radius, 0.13, 0.13 + height, around, rows);
  Wrapped cloth(tube.points, 2e-5);
  cloth.triangles = tube.triangles;
  const double rest = 2 * pi * radius / 1.05 / around;
  for (int row = 0; row <= rows; ++row) {
    const double share = row == 0 || row == rows ? 0.5 : 1;
    for (int i = 0; i < around; ++i) {
      const double k = stiffness * share * height / rows / rest;
      cloth.springs.push_back(
          {row * around + i, row * around + (i + 1) % around, rest, k, 2e-5 * k});
    }
  }
  const double force = cloth.run(radius, 0.2, 50, [](double) {});
  const double pressure = force / (2 * pi * radius * height);
  double strain = 0;
  for (const Spring& s : cloth.springs) strain += (cloth.x[s.a] - cloth.x[s.b]).norm() / s.rest - 1;
  strain /= static_cast<double>(cloth.springs.size());
  const test::ReferenceTable table("case08_polygon.csv");
  test::expect_relative(
      {"too small tube on a cylinder, of 64 sides: hoop strain", "springs", "64 x 4 springs", "%"},
      100 * strain, 100 * table.find("nodes", around, "strain_polygon"), 0.01);
  test::expect_relative(
      {"too small tube on a cylinder, of 64 sides: pressure", "springs", "64 x 4 springs", "Pa"},
      pressure, table.find("nodes", around, "pressure_polygon_Pa"), 0.01);
}

/// m/s: the speed of a strip over half a cylinder when one end is pulled `ratio` times as hard as
/// the other. The pull grows slowly.
double speed_of_strip(double ratio, double friction) {
  constexpr double radius = 0.1;
  constexpr int contacts = 33;
  std::vector<Vec3> points;
  for (int i = 0; i < contacts; ++i) {
    const double angle = pi * i / (contacts - 1);
    for (const double y : {0.14, 0.15}) {
      points.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
    }
  }
  Wrapped cloth(points, 1e-4);
  for (int i = 0; i + 1 < contacts; ++i) {
    const int a = 2 * i;
    cloth.triangles.push_back({a, a + 1, a + 2});
    cloth.triangles.push_back({a + 1, a + 3, a + 2});
    for (const int side : {0, 1}) {
      const double rest = (points[a + side] - points[a + side + 2]).norm();
      cloth.springs.push_back({a + side, a + side + 2, rest, 5 / rest, 1e-4});
    }
  }
  cloth.options.friction = friction;
  const int last = 2 * (contacts - 1);
  constexpr double weight = 0.01;  // N, on each node of the slack end
  constexpr double ramp = 0.6;
  const auto pull = [&](double time) {
    const double now = 1 + (ratio - 1) * std::min(1.0, time / ramp);
    cloth.pull[0] = cloth.pull[1] = Vec3(0, 0, -weight * now);
    cloth.pull[last] = cloth.pull[last + 1] = Vec3(0, 0, -weight);
  };
  cloth.run(radius, 0.9, 5, pull);
  return cloth.v[last].norm();
}

/// Above which a strip runs, m/s.
constexpr double running = 1e-3;

// Reference case 7: T2/T1 = exp(mu phi); for nodes a little above that, +0.05 % at 32 and mu 0.05.
TEST(WrappedCylinder, AStripSlipsWhereTheCapstanEquationSays) {
  constexpr double friction = 0.3;
  const double limit = std::exp(friction * pi);
  double holds = 0.95 * limit, slips = 1.05 * limit;
  EXPECT_LT(speed_of_strip(holds, friction), running);
  EXPECT_GT(speed_of_strip(slips, friction), running);
  while (slips - holds > 0.004 * limit) {
    const double middle = 0.5 * (holds + slips);
    (speed_of_strip(middle, friction) < running ? holds : slips) = middle;
  }
  test::expect_relative({"capstan, half a turn, mu 0.3: ratio of the tensions at which it slips",
                         "springs", "33 nodes around"},
                        0.5 * (holds + slips), limit, 0.02);
}

}  // namespace springs_on_cylinder_test
}  // namespace toile
