// Coulomb's friction: sheets on a slope, a strip around a bar [reference cases 6 and 7].
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/relaxation/release.h"
#include "cloth/scene/collider.h"
#include "geometry/angles.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"
#include "tests/validation/scenes.h"

namespace toile {
namespace friction_test {

constexpr double pi = std::numbers::pi;

Vec3 mean_way(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  Vec3 way = Vec3::Zero();
  for (std::size_t n = 0; n < to.size(); ++n) way += (to[n] - from[n]) / to.size();
  return way;
}

/// A sheet on a slope, come to rest there and let go.
class Incline : public testing::Test {
 protected:
  double way(double slope, double mu, double seconds) {
    static const Collider body{test::box({-0.4, -0.1, -0.2}, {0.9, 0, 0.2})};
    PanelMesh garment;
    test::add_panel(garment, "sheet", test::grid(0.2, 0.2, 8, 8),
                    [&](const Vec2& p) { return Vec3(p.x() - 0.3, 0.002, 0.1 - p.y()); });
    Scene scene;
    scene.collider = &body;
    scene.body_contact = BodyContactTerm::nodes;
    scene.self_contact = false;
    scene.fabric.friction_skin = mu;
    scene.gravity = 9.81 * Vec3(std::sin(slope), -std::cos(slope), 0);
    const GarmentModel model = compile(garment, scene, garment.placed);
    std::vector<Vec3> x = model.start;
    RelaxOptions rest;
    rest.max_iterations = 2000;
    rest.stop_median = rest.stop_rms = 1e-4;
    const RelaxReport rested = relax(model, rest, x);
    ReleaseOptions options;
    options.seconds = seconds;
    options.damping = 0;
    options.warm_start = &rested.warm_start;
    const std::vector<Vec3> from = x;
    last_ = release(model, options, x);
    return mean_way(from, x).x();
  }
  ReleaseReport last_;
};

TEST_F(Incline, SticksAndSlidesAsCoulombSays) {
  const test::ReferenceTable table("case06_incline.csv");
  double creep = 0, nearest = 90, worst = 0;
  int sliding = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double mu = table.at(row, "mu"), slope = table.at(row, "slope_deg");
    if (table.text(row, "set") != "release" || mu == 0) continue;
    if (table.text(row, "state") == "stick") {
      creep = std::max(creep, std::abs(way(to_radians(slope), mu, 0.5)) / 0.5);
      EXPECT_EQ(last_.sticking, 81) << slope;
      EXPECT_TRUE(last_.stays()) << slope;
      nearest = std::min(nearest, table.at(row, "critical_slope_deg") - slope);
      continue;
    }
    ++sliding;
    const double acceleration = table.at(row, "acceleration_m_s2");
    const double seconds = acceleration < 0.5 ? 1 : 0.3;
    const double slid = way(to_radians(slope), mu, seconds);
    worst = std::max(worst, std::abs(slid / (0.5 * acceleration * seconds * seconds) - 1));
  }
  ASSERT_GT(sliding, 10);
  test::expect_near({"slopes below the friction angle, by " + test::number(nearest, 2) +
                         " degrees and more: creep",
                     "release", "8 x 8 sheet", "um/s"},
                    1e6 * creep, 0, 2);
  test::expect_near({"slopes beyond the friction angle, by 0.1 degrees and more: acceleration",
                     "release", "8 x 8 sheet, worst of " + std::to_string(sliding), "%"},
                    100 * worst, 0, 1);
}

/// A weightless strip over a bar along x, loaded at its ends.
class Capstan : public testing::Test {
 protected:
  static constexpr double radius = 0.05, offset = 0.002, edge = 0.004, load = 0.5;  // N/m
  static constexpr int columns = 3, hanging = 6;

  /// How far the strip has run, metres, when its ends pull as 1 to `ratio`.
  double run(double mu, double ratio) {
    static const Collider bar = [] {
      TriangleMesh mesh = test::closed_tube(radius, radius, 0.1, 400);
      for (Vec3& p : mesh.points) p = Vec3(p.y() - 0.04, -p.x(), p.z());
      return Collider{mesh};
    }();
    const double r = radius + offset;
    const int around = static_cast<int>(std::lround(pi * r / edge));
    const int rows = around + 2 * hanging;
    const double step = pi * r / around;
    PanelMesh garment;
    test::add_panel(garment, "strip", test::grid(columns * edge, rows * step, columns, rows),
                    [&](const Vec2& p) {
                      const double s = p.y() - 0.5 * rows * step;
                      const double arc = std::clamp(s, -r * pi / 2, r * pi / 2);
                      return Vec3(p.x(), r * std::cos(arc / r) - (std::abs(s) - std::abs(arc)),
                                  r * std::sin(arc / r));
                    });
    Scene scene;
    scene.collider = &bar;
    scene.body_contact = BodyContactTerm::nodes;
    scene.self_contact = false;
    scene.fabric.friction_skin = mu;
    scene.fabric.stretch_warp = scene.fabric.stretch_weft = 500;
    scene.fabric.shear = 100;
    scene.fabric.bending_warp = scene.fabric.bending_weft = 0;
    scene.fabric.areal_density = 1e-6;
    GarmentModel model = compile(garment, scene, garment.placed);
    double weight = 0;
    for (int n = 0; n < model.nodes; ++n) {
      const double y = garment.flat[n].y();
      const bool slack = y<1e-9, tight = y> rows * step - 1e-9;
      if (!slack && !tight) continue;
      const double x = garment.flat[n].x();
      const double share = x < 1e-9 || x > columns * edge - 1e-9 ? 0.5 : 1;
      model.mass[n] = share * edge * load * (tight ? ratio : 1) / 9.81;
      weight += model.mass[n] * 9.81;
    }
    model.mean_weight = weight / model.nodes;
    std::vector<Vec3> x = model.start;
    RelaxOptions options;
    options.max_iterations = 20000;
    options.stop_median = options.stop_rms = 1e-4;
    converged_ = relax(model, options, x).converged;
    return model.start.back().y() - x.back().y();
  }
  bool converged_ = false;
};

TEST_F(Capstan, SlipsWhereTheCapstanEquationSays) {
  const test::ReferenceTable table("case07_capstan.csv");
  for (const double mu : {0.1, 0.3, 0.5}) {
    double limit = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.at(row, "mu") == mu && table.at(row, "wrap_deg") == 180) {
        limit = table.at(row, "tension_ratio");
      }
    }
    ASSERT_GT(limit, 1);
    double holds = 0.9 * limit, slips = 1.1 * limit;
    EXPECT_LT(run(mu, holds), 0.002);
    EXPECT_TRUE(converged_);
    EXPECT_GT(run(mu, slips), 0.004);
    EXPECT_FALSE(converged_);
    while (slips - holds > 0.004 * limit) {
      const double middle = 0.5 * (slips + holds);
      run(mu, middle);
      (converged_ ? holds : slips) = middle;
    }
    test::expect_relative({"capstan, half a turn, mu " + test::number(mu) +
                               ": ratio of the tensions at which it slips",
                           "relaxation", "41 rows around"},
                          0.5 * (holds + slips), limit, 0.02);
  }
}

}  // namespace friction_test
}  // namespace toile
