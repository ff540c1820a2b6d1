// How fast errors fall with the step and with the mesh, for each method [reference cases 2, 3, 10].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth/model/compile.h"
#include "cloth/relaxation/release.h"
#include "tests/cloth/panels.h"
#include "tests/support/spring_motion.h"
#include "tests/validation/report.h"
#include "tests/validation/scenes.h"

namespace toile {
namespace order_test {

constexpr double pi = std::numbers::pi;

/// Orders between neighbouring errors of resolutions that double, the last one asserted.
void expect_order(const test::Figure& figure, const std::vector<double>& errors, double order,
                  double bound) {
  std::string all;
  for (const double error : errors) all += (all.empty() ? "" : ", ") + test::number(error, 3);
  const std::size_t last = errors.size() - 1;
  test::Figure told = figure;
  told.reason = "errors " + all;
  test::expect_near(told, std::log2(errors[last - 1] / errors[last]), order, bound);
}

/// A sheet in free fall; the step of release() goes with the square root of its stiffness.
TEST(Order, OfTheReleaseInItsStep) {
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 4, 4));
  std::vector<double> errors, steps;
  for (const double stiffness : {100.0, 400.0, 1600.0}) {
    Scene scene;
    scene.self_contact = false;
    scene.fabric.stretch_warp = scene.fabric.stretch_weft = stiffness;
    scene.fabric.shear = 0.2 * stiffness;
    scene.fabric.bending_warp = scene.fabric.bending_weft = 0;
    const GarmentModel model = compile(garment, scene, garment.placed);
    ReleaseOptions options;
    options.seconds = 0.2;
    options.damping = 0;
    std::vector<Vec3> x = model.start;
    const ReleaseReport report = release(model, options, x);
    double fallen = 0;
    for (std::size_t n = 0; n < x.size(); ++n) fallen += model.start[n].y() - x[n].y();
    errors.push_back(std::abs(fallen / x.size() - 0.5 * 9.81 * 0.04));
    steps.push_back(report.time_step);
  }
  ASSERT_NEAR(steps[1] / steps[2], 2, 0.1);
  expect_order(
      {"order in the step: place of a falling sheet", "release",
       "steps " + test::number(1e3 * steps[0], 2) + ", " + test::number(1e3 * steps[1], 2) + ", " +
           test::number(1e3 * steps[2], 2) + " ms"},
      errors, 1, 0.1);
}

/// A mass on a spring, at rest when let go: its place after most of a period.
TEST(Order, OfTheSpringsInTheirStep) {
  std::vector<double> errors, of_period;
  const double seconds = 0.8, rate = std::sqrt(10 / 0.01);
  for (const int steps : {400, 800, 1600}) {
    test::SpringMotion motion(test::spring_chain(1, 1, 10), {{0, 0, 0}, {1.01, 0, 0}}, {0, 0.01}, 0,
                              Vec3::Zero());
    const double dt = seconds / steps;
    for (int n = 0; n < steps; ++n) motion.step(dt);
    errors.push_back(std::abs(motion.x[1].x() - 1 - 0.01 * std::cos(rate * seconds)) / 0.01);
    const double z = rate * dt;
    of_period.push_back(std::abs(z / (2 * std::asin(z / 2)) - 1));
  }
  expect_order({"order in the step: place of a mass on a spring", "springs", "400 to 1600 steps"},
               errors, 1, 0.15);
}

/// Sag of a strip between two ends, against four times as fine.
double sag_of(int columns, bool of_springs) {
  const double length = 1, span = 0.8;
  PanelMesh garment;
  test::add_panel(garment, "strip", test::grid(length, 0.05, columns, 2), [&](const Vec2& p) {
    return Vec3(span * p.x(), -0.6 * std::min(p.x(), 1 - p.x()), -p.y());
  });
  Scene scene;
  scene.self_contact = false;
  scene.fabric.areal_density = 0.2;
  scene.fabric.stretch_warp = scene.fabric.stretch_weft = 2000;
  scene.fabric.shear = 600;
  scene.fabric.bending_warp = scene.fabric.bending_weft = 0;
  GarmentModel model = compile(garment, scene, garment.placed);
  test::hold(model, [&](const Vec3& p) { return p.x() == 0 || p.x() == span; });
  const std::vector<Vec3> x = of_springs ? test::sprung(garment, model, {.seconds = 8, .drag = 12})
                                         : test::relaxed(model, 1e-8);
  double lowest = 0;
  for (const Vec3& p : x) lowest = std::min(lowest, p.y());
  return -lowest;
}

TEST(Order, OfTheCatenaryInItsMesh) {
  constexpr double sag = 0.265765565702154;  // case 2, elastic_Y2000_equal
  for (const bool of_springs : {false, true}) {
    std::vector<double> errors;
    for (const int columns : {8, 16, 32}) {
      errors.push_back(std::abs(sag_of(columns, of_springs) - sag));
    }
    expect_order({"order in the mesh: sag of the catenary, m",
                  of_springs ? "springs" : "relaxation", "8, 16, 32 columns"},
                 errors, 2, 0.15);
  }
}

}  // namespace order_test
}  // namespace toile
