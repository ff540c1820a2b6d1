#include "cloth/contact/pair_friction.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <iostream>
#include <numbers>
#include <optional>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/relaxation/release.h"
#include "cloth/scene/collider.h"
#include "geometry/angles.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"

namespace toile {
namespace pair_friction_test {

/// A patch of cloth on a motionless layer of cloth, both on a slope. Reference case 06, incline.
class ClothOnCloth : public testing::Test {
 protected:
  static constexpr double gap = 0.001;

  ClothOnCloth() {
    const PlanarMesh flat = test::grid(0.41, 0.2, 29, 14);
    for (const Vec2& p : flat.points) layer.points.emplace_back(p.x() - 0.2, 0, 0.1 - p.y());
    layer.triangles = flat.triangles;
    test::add_panel(patch, "patch", test::grid(0.1, 0.1, 9, 9),
                    [](const Vec2& p) { return Vec3(p.x() - 0.153, 0.99 * gap, 0.0513 - p.y()); });
    collider.emplace(test::box({5, 5, 5}, {6, 6, 6}));
    collider->add_layer(layer);
    scene.collider = &*collider;
    scene.body_contact = BodyContactTerm::none;
    scene.layer_gap = gap;
  }

  /// Metres that the patch slides down the slope in `seconds`, after it came to rest there.
  double slid_distance(double slope, double mu, double seconds, bool hand_over = true) {
    scene.fabric.friction_cloth = mu;
    scene.gravity = 9.81 * Vec3(std::sin(slope), -std::cos(slope), 0);
    const GarmentModel model = compile(patch, scene, patch.placed);
    std::vector<Vec3> x = model.start;
    RelaxOptions rest;
    rest.bounded = rest.layer_contact = true;
    rest.max_iterations = 1500;
    rest.stop_median = rest.stop_rms = 1e-4;
    const RelaxReport rested = relax(model, rest, x);
    anchors = rested.warm_start.pair_anchors.size();
    ReleaseOptions options;
    options.layer_contact = true;
    options.bounded = hand_over;  // bounds stop a sliding patch now and then
    options.seconds = seconds;
    options.damping = 0;
    if (hand_over) options.warm_start = &rested.warm_start;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : x) middle -= p / static_cast<double>(x.size());
    report = release(model, options, x);
    for (const Vec3& p : x) middle += p / static_cast<double>(x.size());
    return middle.x();
  }

  TriangleMesh layer;
  std::optional<Collider> collider;
  PanelMesh patch;
  Scene scene;
  std::size_t anchors = 0;
  ReleaseReport report;
};

TEST_F(ClothOnCloth, SticksBelowTheFrictionAngle) {
  for (const double slope : {5.0, 10.0, 15.0, 16.0}) {  // the friction angle is 16.7
    const double crept = slid_distance(to_radians(slope), 0.3, 0.5);
    std::cout << slope << " degrees: crept " << 1000 * crept << " mm, at most "
              << 1000 * report.all.max << ", " << anchors << " anchors\n";
    EXPECT_GT(anchors, 100U);
    EXPECT_LT(std::abs(crept), 1e-5) << slope;
    EXPECT_LT(report.all.max, 1e-4) << slope;
  }
}

TEST_F(ClothOnCloth, SlidesBeyondItAsCoulombSays) {
  for (const double slope : {18.0, 20.0, 25.0, 30.0}) {
    const double slid = slid_distance(to_radians(slope), 0.3, 0.2, false);
    const double wanted =
        0.5 * 9.81 * (std::sin(to_radians(slope)) - 0.3 * std::cos(to_radians(slope))) * 0.04;
    std::cout << slope << " degrees: slid " << 1000 * slid << " of " << 1000 * wanted
              << " mm, off by " << 100 * (slid / wanted - 1) << " %\n";
    EXPECT_NEAR(slid / wanted, 1, 0.05) << slope;
  }
}

TEST_F(ClothOnCloth, TheSameBitsForAnyNumberOfThreads) {
  const auto run = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    slid_distance(to_radians(18), 0.3, 0.02);
    return report.moved;
  };
  EXPECT_TRUE(run(1) == run(2));
  EXPECT_GT(anchors, 128U);  // several chunks
}

/// Two tubes of cloth around an upright cylinder, one over the other. The strain of the outer one
/// gives it a hoop tension of `share` times W/(2 pi mu). With a share of 1, friction on the inner
/// tube just carries its weight W. The skin is rougher, and holds the inner tube.
class TubeOnTube : public testing::Test {
 protected:
  static constexpr double radius = 0.1, mu = 0.3, row = 0.0125;
  static constexpr int columns = 48;

  void add_tube(const std::string& name, double flat_girth, double out, double bottom, int rows) {
    const auto place = [&](const Vec2& p) {
      const double angle = 2 * std::numbers::pi * p.x() / flat_girth;
      return Vec3(out * std::sin(angle), bottom + p.y(), out * std::cos(angle));
    };
    const MeshedPanel& panel =
        test::add_panel(tubes, name, test::grid(flat_girth, rows * row, columns, rows), place);
    tubes.seams.push_back(test::seam(name, test::side(panel, columns, rows, false),
                                     test::side(panel, columns, rows, true)));
  }

  /// Metres that the outer tube, and the inner one, slide down in `seconds`.
  std::pair<double, double> sink(double share, double seconds) {
    static const Collider body{test::closed_tube(radius, radius, 1, 400)};
    Scene scene;
    scene.collider = &body;
    scene.body_contact = BodyContactTerm::nodes;
    Fabric& fabric = scene.fabric;
    // Heavy cloth, for release() gives more mass to nodes too light for the stiffness of contact.
    fabric.areal_density = 0.6;
    fabric.stretch_warp = fabric.stretch_weft = 200;
    fabric.shear = 80;
    fabric.friction_skin = 1;
    fabric.friction_cloth = mu;
    // Radii at which the smooth grid is 2 mm off: at the nodes, and at the middles of the edges.
    const double skin = radius + 0.004 - body.grid().at({0, 0.7, radius + 0.002}).distance;
    const double out = skin + scene.self_gap / std::cos(std::numbers::pi / columns);
    const double side = 2 * columns * std::sin(std::numbers::pi / columns);
    const double load =
        share * fabric.areal_density * 9.81 * side * out / (2 * std::numbers::pi * mu);
    tubes = {};
    add_tube("inner", side * skin / 1.01, skin, 0.66, 8);
    add_tube("outer", side * out / (1 + load / fabric.stretch_weft), out, 0.70, 4);
    const GarmentModel model = compile(tubes, scene, tubes.placed);
    std::vector<Vec3> x = model.start;
    RelaxOptions rest;
    rest.bounded = true;
    rest.gravity = 0;
    rest.max_iterations = 4000;
    rest.stop_median = rest.stop_rms = 1e-4;
    relax(model, rest, x);
    RelaxReport rested;
    if (share > 1) {
      rest.gravity = 1;
      rested = relax(model, rest, x);
      EXPECT_TRUE(rested.converged);
    }
    ReleaseOptions options;
    options.bounded = share > 1;  // bounds stop a sliding tube now and then
    options.seconds = seconds;
    options.damping = share > 1 ? 1 : 0;
    if (share > 1) options.warm_start = &rested.warm_start;
    const std::vector<Vec3> from = x;
    report = release(model, options, x);
    std::array<double, 2> sunk{};
    for (int panel = 0; panel < 2; ++panel) {
      const MeshedPanel& tube = tubes.panels[panel];
      for (int p = tube.first_point; p < tube.first_point + tube.points; ++p) {
        const int n = model.node_of_point[p];
        sunk[panel] += (from[n].y() - x[n].y()) / tube.points;
      }
    }
    return {sunk[1], sunk[0]};
  }

  PanelMesh tubes;
  ReleaseReport report;
};

TEST_F(TubeOnTube, HoldsItsWeightByHoopTension) {
  for (const double share : {1.1, 1.5}) {
    const auto [outer, inner] = sink(share, 1);
    std::cout << "tension " << share << " of what is needed: outer crept " << 1000 * outer
              << " mm in 1 s, inner " << 1000 * inner << ", at most " << 1000 * report.all.max
              << "; " << report.steps << " steps\n";
    EXPECT_LT(std::abs(outer), 1e-5);
    EXPECT_LT(report.all.max, 5e-5);  // 0.5 mm in 10 s
  }
}

TEST_F(TubeOnTube, SlidesWhereTheTensionIsTooLittle) {
  constexpr double seconds = 0.1;
  for (const double share : {0.95, 0.9}) {
    const auto [outer, inner] = sink(share, seconds);
    const double friction = 1 - outer / (0.5 * 9.81 * seconds * seconds);
    std::cout << "tension " << share << " of what is needed: slid " << 1000 * outer
              << " mm, so friction carries " << friction << " of its weight; inner " << 1000 * inner
              << " mm\n";
    EXPECT_NEAR(friction / share, 1, 0.03);
    EXPECT_LT(std::abs(inner), 1e-4);
  }
}

/// Two edges of two fabrics press on each other. One is dragged over the other.
TEST(PairFriction, IsTheSmootherSidesAndLetsGo) {
  const ContactPair pair = {{0, 1, 2, 3}, true, 0.002};
  PairFriction friction;
  friction.set_coefficients({0.2, 0.4, 0.5, 0.5});
  friction.activate({pair});
  constexpr double push = 0.01, most = 0.3 * push;
  const auto drag = [&](double displacement, double pushed) {
    const std::vector<Vec3> at = {{-0.01 + displacement, 0.001, 0},
                                  {0.01 + displacement, 0.001, 0},
                                  {0, 0, -0.01},
                                  {0, 0, 0.01}};
    Vec4s on(4, Vec4{});
    friction.add(0, nearest_points(pair, at), pushed, as_vec4(at), on.data());
    EXPECT_NEAR(on[0][0] + on[1][0], -(on[2][0] + on[3][0]), 1e-15);
    return on[0][0] + on[1][0];
  };
  EXPECT_EQ(drag(0, push), 0);
  EXPECT_NEAR(drag(1e-5, push), -50 * 1e-5, 1e-12);
  EXPECT_NEAR(drag(0.001, push), -most, 1e-12);
  // Pushed back by half of the distance by which it is dragged.
  EXPECT_NEAR(drag(0.001 - 0.5 * most / 50, push), -0.5 * most, 1e-12);

  // The anchor survives another activate() and goes to another run; a pair apart loses it.
  friction.activate({{{4, 5, 6, 7}, true, 0.002}, pair});
  ASSERT_EQ(friction.anchors().size(), 1U);
  PairFriction next;
  next.set_coefficients({0.2, 0.4, 0.5, 0.5});
  next.set_anchors(friction.anchors());
  friction = next;
  friction.activate({pair});
  EXPECT_NEAR(drag(0.001, push), -most, 1e-12);
  EXPECT_EQ(drag(0.001, 0), 0);
  EXPECT_TRUE(friction.anchors().empty());
  EXPECT_EQ(drag(0.001, push), 0);
}

TEST(PairFriction, CostsNothingWithoutCoefficients) {
  PairFriction friction;
  friction.set_coefficients({0, 0, 0, 0});
  friction.activate({{{0, 1, 2, 3}, true, 0.002}});
  EXPECT_TRUE(friction.empty());
}

}  // namespace pair_friction_test
}  // namespace toile
