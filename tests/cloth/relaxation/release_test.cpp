#include "cloth/relaxation/release.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <numbers>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"

namespace toile {
namespace release_test {

constexpr double pi = std::numbers::pi;

Vec3 mean_way(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  Vec3 displacement = Vec3::Zero();
  for (std::size_t n = 0; n < to.size(); ++n) displacement += (to[n] - from[n]) / to.size();
  return displacement;
}

TEST(Release, AFreeSheetFallsAsDampingLetsIt) {
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 5, 5));
  const GarmentModel model = compile(garment, {}, garment.placed);
  for (const double damping : {0.0, 1.0}) {
    ReleaseOptions options;
    options.seconds = 0.3;
    options.damping = damping;
    std::vector<Vec3> x = model.start;
    const ReleaseReport report = release(model, options, x);
    const double t = options.seconds;
    const double fallen = damping > 0
                              ? 9.81 / damping * (t - (1 - std::exp(-damping * t)) / damping)
                              : 0.5 * 9.81 * t * t;
    const double speed = damping > 0 ? 9.81 / damping * (1 - std::exp(-damping * t)) : 9.81 * t;
    // The symplectic step is half a step ahead.
    EXPECT_NEAR(-mean_way(model.start, x).y(), fallen, 9.81 * t * report.time_step);
    EXPECT_NEAR(report.speed_p99, speed, 9.81 * report.time_step);
    EXPECT_NEAR(report.all.median, fallen, 9.81 * t * report.time_step);
    const double kinetic = 0.5 * 0.15 * 0.01 * speed * speed;
    EXPECT_NEAR(report.kinetic / kinetic, 1, 1e-3);
    // All work of the weight became speed, or was damped.
    EXPECT_NEAR(report.released_energy / (0.15 * 0.01 * 9.81 * fallen), 1, 0.05) << damping;
    EXPECT_FALSE(report.stays());
  }
}

TEST(Release, RingsAndLosesEnergyAsTheStepSays) {
  // A flat sheet, stretched a little and released, oscillates at the speed of sound in it.
  const double length = 0.2, width = 0.02, amplitude = 1e-4;
  const PanelMesh garment = test::flat_panel(test::grid(length, width, 40, 4));
  const GarmentModel model = compile(garment, {}, garment.placed);
  const Fabric& fabric = model.scene.fabric;
  ReleaseOptions options;
  options.gravity = 0;
  options.damping = 0;
  std::vector<Vec3> stretched = model.start;
  for (Vec3& p : stretched) p.x() += amplitude * std::sin(pi * (p.x() / length - 0.5));
  // A wave needs half a period along the sheet. After a quarter, all energy is kinetic.
  const double half = length / std::sqrt(fabric.stretch_weft / fabric.areal_density);
  const double energy = 0.25 * fabric.stretch_weft * width * std::pow(amplitude * pi, 2) / length;
  for (const int halves : {0, 1, 20}) {
    options.seconds = (halves + 0.5) * half;
    std::vector<Vec3> x = stretched;
    const ReleaseReport report = release(model, options, x);
    // Forces are taken a tenth of a step ahead of the nodes.
    const double rate = 0.1 * report.time_step * std::pow(pi / half, 2);
    const double left = energy * std::exp(-rate * options.seconds);
    std::cout << "after " << halves << " half periods: energy " << report.kinetic / energy
              << " of what was put in, off by " << 100 * (report.kinetic / left - 1) << " %\n";
    EXPECT_NEAR(report.kinetic / left, 1, 0.02) << halves;
  }
}

/// A band of 5 cm around an upright cylinder. Its strain gives it a hoop tension of `share` times
/// W/(2π mu). With a share of 1, friction just carries its weight W.
class Band : public testing::Test {
 protected:
  static constexpr double radius = 0.1, height = 0.05, mu = 0.4;
  static constexpr int columns = 48, rows = 4;

  /// Metres that the band slides down in `seconds`.
  double sink(double share, double seconds) {
    static const Collider body{test::closed_tube(radius, radius, 1, 400)};
    // The radius at which the smooth grid is 2 mm off.
    const double out = radius + 0.004 - body.grid().at({0, 0.7, radius + 0.002}).distance;
    Scene scene;
    scene.collider = &body;
    scene.body_contact = BodyContactTerm::nodes;
    scene.self_contact = false;
    scene.fabric.stretch_warp = scene.fabric.stretch_weft = 50;
    scene.fabric.shear = 20;
    scene.fabric.friction_skin = mu;
    const double polygon = 2 * columns * out * std::sin(pi / columns);
    // Tension and weight, both per metre of height: Y·strain = share·rho·g·girth/(2π mu).
    const double load = share * scene.fabric.areal_density * 9.81 / (2 * pi * mu);
    const double girth = polygon / (1 + load * polygon / scene.fabric.stretch_weft);
    PanelMesh garment;
    test::add_panel(garment, "band", test::grid(girth, height, columns, rows), [&](const Vec2& p) {
      const double angle = 2 * pi * p.x() / girth;
      return Vec3(out * std::sin(angle), 0.7 + p.y(), out * std::cos(angle));
    });
    garment.seams = {test::seam("", test::side(garment.panels[0], columns, rows, false),
                                test::side(garment.panels[0], columns, rows, true))};
    const GarmentModel model = compile(garment, scene, garment.placed);
    std::vector<Vec3> x = model.start;
    RelaxOptions rest;
    rest.gravity = 0;
    rest.max_iterations = 4000;
    rest.stop_median = rest.stop_rms = 1e-4;
    relax(model, rest, x);
    rest.gravity = 1;
    RelaxReport rested;
    if (share > 1) {
      rested = relax(model, rest, x);
      EXPECT_TRUE(rested.converged);
    }
    ReleaseOptions options;
    options.seconds = seconds;
    options.damping = share > 1 ? 1 : 0;
    if (share > 1) options.warm_start = &rested.warm_start;
    const std::vector<Vec3> from = x;
    last_ = release(model, options, x);
    return -mean_way(from, x).y();
  }
  ReleaseReport last_;
};

TEST_F(Band, HoldsItsWeightByHoopTension) {
  for (const double share : {1.05, 1.5}) {
    const double sunk = sink(share, 10);
    std::cout << "tension " << share << " of what is needed: crept " << 1000 * last_.all.max
              << " mm in 10 s, " << last_.steps << " steps\n";
    EXPECT_LT(std::abs(sunk), 1e-5);
    EXPECT_LT(last_.all.max, 0.0005);
    EXPECT_TRUE(last_.stays());
  }
}

TEST_F(Band, SlidesWhereTheTensionIsTooLittle) {
  for (const double share : {0.9, 0.5}) {
    const double sunk = sink(share, 0.3);
    const double wanted = 0.5 * 9.81 * (1 - share) * 0.09;
    std::cout << "tension " << share << " of what is needed: slid " << 1000 * sunk << " mm, "
              << 1000 * wanted << " mm by Coulomb's law\n";
    EXPECT_NEAR(sunk / wanted, 1, 0.05) << share;
    EXPECT_FALSE(last_.stays());
  }
}

TEST(Release, TheSameBitsForAnyNumberOfThreads) {
  const Collider body{test::closed_tube(0.03, 0.03, 0.5, 100)};
  const PanelMesh garment = [] {
    PanelMesh sheet;
    test::add_panel(sheet, "sheet", test::grid(0.5, 0.5, 50, 50),
                    [](const Vec2& p) { return Vec3(p.x() - 0.25, 0.505, p.y() - 0.25); });
    return sheet;
  }();
  Scene scene;
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  const GarmentModel model = compile(garment, scene, garment.placed);
  ASSERT_GT(model.nodes, 2048);  // several chunks
  ReleaseOptions options;
  options.seconds = 0.02;
  options.bounded = true;
  const auto run = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<Vec3> x = model.start;
    release(model, options, x);
    return x;
  };
  const std::vector<Vec3> one = run(1);
  EXPECT_TRUE(one == run(2));
  EXPECT_FALSE(one == model.start);
}

}  // namespace release_test
}  // namespace toile
