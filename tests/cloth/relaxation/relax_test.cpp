#include "cloth/relaxation/relax.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "cloth/model/compile.h"
#include "cloth/scene/collider.h"
#include "geometry/angles.h"
#include "geometry/distance_grid.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace relax_test {

constexpr double pi = std::numbers::pi;

/// The displacement (metres) of a sheet of 20 x 20 cm on a flat box, with gravity at `slope`.
Vec3 slide(double slope, double height, RelaxReport& report, std::vector<Vec3>& x,
           bool friction = true, int iterations = 6000) {
  static const Collider body{test::box({-0.4, -0.1, -0.2}, {0.4, 0, 0.2})};
  PanelMesh garment;
  test::add_panel(garment, "sheet", test::grid(0.2, 0.2, 20, 20),
                  [&](const Vec2& p) { return Vec3(p.x() - 0.1, height, 0.1 - p.y()); });
  Scene scene;
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  scene.fabric.friction_skin = 0.4;
  scene.gravity = 9.81 * Vec3(std::sin(slope), -std::cos(slope), 0);
  const GarmentModel model = compile(garment, scene, garment.placed);
  x = model.start;
  RelaxOptions options;
  options.friction = friction;
  options.max_iterations = iterations;
  options.stop_median = 0.001;
  options.stop_rms = 0.01;
  report = relax(model, options, x);
  Vec3 displacement = Vec3::Zero();
  for (std::size_t n = 0; n < x.size(); ++n) displacement += (x[n] - model.start[n]) / x.size();
  return displacement;
}

/// A sheet of 20 cm falls on a sharp ridge of motionless cloth, 1 cm below it.
std::vector<Vec3> fall_on_a_ridge(bool layer_contact, TriangleMesh& cloth, TriangleMesh& ridge) {
  PanelMesh garment;
  test::add_panel(garment, "sheet", test::grid(0.2, 0.2, 10, 10),
                  [](const Vec2& p) { return Vec3(p.x() - 0.1, 0.01, 0.103 - p.y()); });
  ridge.points = {{-0.3, 0, 0},     {0.3, 0, 0},        {-0.3, -0.3, 0.1},
                  {0.3, -0.3, 0.1}, {-0.3, -0.3, -0.1}, {0.3, -0.3, -0.1}};
  ridge.triangles = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}};
  Scene scene;
  // No body pushes; only the edge of the ridge does.
  Collider collider(test::box({5, 5, 5}, {6, 6, 6}));
  collider.add_layer(ridge);
  scene.collider = &collider;
  scene.body_contact = BodyContactTerm::none;
  const GarmentModel model = compile(garment, scene, garment.placed);
  std::vector<Vec3> x = model.start;
  RelaxOptions options;
  options.bounded = true;
  options.layer_contact = layer_contact;
  options.max_iterations = 3000;
  relax(model, options, x);
  cloth = {x, model.node_triangles};
  return x;
}

TEST(Relax, ALayerBelowHoldsTheClothWithItsEdges) {
  // Where they touch, no node of one is over a face of the other. So only edges can hold.
  TriangleMesh cloth, ridge;
  const std::vector<Vec3> held = fall_on_a_ridge(true, cloth, ridge);
  EXPECT_TRUE(intersections(cloth, ridge).empty());
  EXPECT_EQ(held.size(), 121U) << "the layer's points are none of the state";
  double nearest = 1, lowest = 1;
  for (const Vec3& p : held) {
    const double below = std::abs(p.z()) * 3;  // the ridge's height there
    nearest = std::min(nearest, (p.y() + below) * std::sin(std::atan(1.0 / 3)));
    lowest = std::min(lowest, p.y());
  }
  RecordProperty("nearest_node_mm", std::to_string(1000 * nearest));
  EXPECT_GT(nearest, 0);
  EXPECT_LT(lowest, -0.03) << "it hangs down on both sides";
  EXPECT_GT(held[60].y(), 0);
  const std::vector<Vec3> lost = fall_on_a_ridge(false, cloth, ridge);
  EXPECT_LT(lost[60].y(), -0.05);
}

TEST(Relax, AFallenSheetLiesFlatAtItsOffset) {
  RelaxReport report;
  std::vector<Vec3> x;
  const Vec3 displacement = slide(0, 0.012, report, x);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.residual.median, 0.001);
  EXPECT_LT(report.residual.rms, 0.01);
  EXPECT_LT(report.iterations, 6000);
  for (const Vec3& p : x) ASSERT_NEAR(p.y(), 0.002, 2e-5);
  EXPECT_NEAR(displacement.y(), -0.010, 2e-5);
  EXPECT_LT(std::hypot(displacement.x(), displacement.z()), 1e-5);
}

/// The weight of this sheet moves its nodes by millimetres in a step. They must not be thrown back
/// from the body and come down again without end.
TEST(Relax, ABandAsSoftAsAWebComesToRestAroundABody) {
  const Collider body(test::closed_tube(0.1, 0.1, 0.4, 128));
  Scene scene;
  scene.collider = &body;
  scene.fabric.stretch_warp = scene.fabric.stretch_weft = 1;
  scene.fabric.shear = 0.2;
  RelaxOptions options;
  options.max_iterations = 20000;
  options.stop_median = options.stop_rms = 0.01;
  PanelMesh garment;
  test::add_panel(garment, "band", test::grid(0.5, 0.05, 20, 2), [](const Vec2& p) {
    const double angle = 2 * std::numbers::pi * p.x() / 0.5;
    return Vec3(0.11 * std::sin(angle), 0.2 + p.y(), 0.11 * std::cos(angle));
  });
  garment.seams = {test::seam("", test::side(garment.panels[0], 20, 2, false),
                              test::side(garment.panels[0], 20, 2, true))};
  const GarmentModel model = compile(garment, scene, garment.placed);
  std::vector<Vec3> x = model.start;
  const RelaxReport report = relax(model, options, x);
  EXPECT_TRUE(report.converged) << report.residual.median << ", " << report.residual.rms;
  EXPECT_LT(report.iterations, 1000);
}

TEST(Relax, FrictionHoldsBelowItsAngleOnly) {
  // tan 21.8 degrees = 0.4.
  RelaxReport report;
  std::vector<Vec3> x;
  for (const double angle : {10.0, 20.0, 21.3}) {
    const double displacement = slide(to_radians(angle), 0.002, report, x).norm();
    EXPECT_LT(displacement, 1e-5) << angle;
    EXPECT_TRUE(report.converged) << angle;
  }
  // Beyond, the sheet slides as long as the run lasts; without friction, on the smallest slope.
  for (const double angle : {22.3, 25.0}) {
    const double displacement = slide(to_radians(angle), 0.002, report, x).x();
    EXPECT_FALSE(report.converged) << angle;
    EXPECT_GT(displacement, 0.0006) << angle;
    const double farther = slide(to_radians(angle), 0.002, report, x, true, 12000).x();
    EXPECT_GT(farther, 2 * displacement) << angle;
    EXPECT_FALSE(report.converged) << angle;
  }
  EXPECT_GT(slide(to_radians(2), 0.002, report, x, false).x(), 0.002);
}

/// Two flat panels on either side of an upright cylinder of 20 cm across.
PanelMesh around_cylinder(double width, int columns, int rows) {
  PanelMesh garment;
  const PlanarMesh mesh = test::grid(width, 0.15, columns, rows);
  test::add_panel(garment, "front", mesh,
                  [&](const Vec2& p) { return Vec3(p.x() - width / 2, 0.2 + p.y(), 0.16); });
  test::add_panel(garment, "back", mesh,
                  [&](const Vec2& p) { return Vec3(width / 2 - p.x(), 0.2 + p.y(), -0.16); });
  garment.seams = test::side_seams(garment, columns, rows);
  return garment;
}

RelaxOptions sewing() {
  RelaxOptions options;
  options.closing_iterations = 2000;
  options.max_iterations = 6000;
  options.bending_from = options.bending_to = 100;
  options.gravity = 0;
  options.body_attraction = 2;
  options.friction = false;
  options.bounded = true;
  options.momentum = 0.99;
  return options;
}

TEST(Relax, SeamsCloseAroundABody) {
  const Collider body{test::closed_tube(0.1, 0.1, 0.5, 200)};
  const int columns = 24, rows = 10;
  const PanelMesh garment = around_cylinder(0.36, columns, rows);  // 9 cm of ease
  Scene scene;
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  const GarmentModel model = compile(garment, scene, garment.placed);
  std::vector<Vec3> x = model.start;
  std::vector<double> last_open(model.nodes, 1);
  int calls = 0;
  const RelaxReport report = relax(model, sewing(), x, [&](const RelaxProgress& at) {
    for (std::size_t n = 0; n < at.open.size(); ++n) EXPECT_LE(at.open[n], last_open[n]);
    last_open = at.open;
    ++calls;
    // No state of the run intersects itself.
    if (calls % 8 == 0) {
      const auto points = point_positions(model, at.nodes, at.open);
      EXPECT_TRUE(self_intersections({points, model.triangles}).empty()) << at.iteration;
    }
  });
  EXPECT_GE(calls, 40);
  EXPECT_TRUE(report.converged);
  EXPECT_TRUE(report.open.empty());
  const std::vector<Vec3> points = point_positions(model, x);
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      EXPECT_EQ(points[seam.a[i]], points[seam.b[i]]);
    }
  }
  EXPECT_TRUE(self_intersections({x, model.node_triangles}).empty());
  for (const Vec3& p : x) EXPECT_GT(std::hypot(p.x(), p.z()), 0.1);
  // Each row of points winds once around the body.
  for (int row = 0; row <= rows; ++row) {
    double turn = 0;
    for (int panel = 0; panel < 2; ++panel) {
      for (int i = 0; i < columns; ++i) {
        const Vec3& a = points[garment.panels[panel].first_point + row * (columns + 1) + i];
        const Vec3& b = points[garment.panels[panel].first_point + row * (columns + 1) + i + 1];
        turn += std::atan2(a.z() * b.x() - a.x() * b.z(), a.x() * b.x() + a.z() * b.z());
      }
    }
    EXPECT_NEAR(turn, 2 * pi, 1e-9) << row;
  }
}

/// The seams of two panels of 10 cm are closed around a body between them.
struct NarrowPanels {
  explicit NarrowPanels(const TriangleMesh& between, bool passes_body)
      : mesh(between), collider(between) {
    const PanelMesh garment = around_cylinder(0.1, 8, 8);
    Scene scene;
    scene.collider = &collider;
    model = compile(garment, scene, garment.placed);
    nodes = model.start;
    RelaxOptions options = sewing();
    options.barrier = true;
    options.passing_iterations = 1000;
    options.passes_body = passes_body;
    options.bounded_by_body = true;
    report = relax(model, options, nodes);
  }
  std::size_t crossings(const std::vector<Vec3>& at, const std::vector<double>& open) const {
    return intersections({point_positions(model, at, open), model.triangles}, mesh).size();
  }

  TriangleMesh mesh;
  Collider collider;
  GarmentModel model;
  std::vector<Vec3> nodes;
  RelaxReport report;
};

TEST(Relax, FarTooNarrowPanelsCloseAroundABodyAndClearOfIt) {
  // Their girth is a third of the cylinder's.
  const NarrowPanels panels(test::closed_tube(0.1, 0.1, 0.5, 100), false);
  EXPECT_TRUE(panels.report.converged);
  EXPECT_EQ(panels.crossings(panels.nodes, {}), 0U);
}

TEST(Relax, SeamsOnEitherSideOfAWallStayOpenOrPassItAsAsked) {
  const TriangleMesh wall = test::box({-1, 0, -0.1}, {1, 0.6, 0.1});
  const NarrowPanels stopped(wall, false);
  EXPECT_FALSE(stopped.report.converged);
  const std::vector<double>& open = stopped.report.open;
  ASSERT_EQ(open.size(), stopped.nodes.size());
  EXPECT_EQ(stopped.crossings(stopped.nodes, open), 0U);
  // They began 32 cm apart.
  EXPECT_GE(*std::ranges::max_element(open), 0.2 / 0.32);

  const NarrowPanels passed(wall, true);
  EXPECT_TRUE(passed.report.converged);
  ASSERT_EQ(passed.report.held.nodes.size(), passed.nodes.size());
  EXPECT_EQ(passed.crossings(passed.report.held.nodes, passed.report.held.open), 0U);
}

TEST(Relax, AnOpenSeamIsWhereItWasPlaced) {
  const PanelMesh garment = around_cylinder(0.36, 8, 4);
  const GarmentModel model = compile(garment, {}, garment.placed);
  const std::vector<Vec3> open =
      point_positions(model, model.start, std::vector<double>(model.nodes, 1));
  const std::vector<Vec3> half =
      point_positions(model, model.start, std::vector<double>(model.nodes, 0.5));
  for (std::size_t p = 0; p < open.size(); ++p) {
    EXPECT_LT((open[p] - garment.placed[p]).norm(), 1e-15);
  }
  const MeshedSeam& seam = garment.seams[0];
  EXPECT_NEAR((half[seam.a[2]] - half[seam.b[2]]).norm(), 0.16, 1e-12);
}

class SameBits : public testing::TestWithParam<BodyContactTerm> {};

TEST_P(SameBits, ForAnyNumberOfThreads) {
  const Collider body{test::closed_tube(0.1, 0.1, 0.5, 100)};
  const PanelMesh garment = around_cylinder(0.36, 48, 24);
  Scene scene;
  scene.collider = &body;
  scene.body_contact = GetParam();
  const GarmentModel model = compile(garment, scene, garment.placed);
  ASSERT_GT(model.nodes, 2048);  // several chunks
  RelaxOptions closing = sewing();
  closing.closing_iterations = 150;
  closing.max_iterations = 400;
  closing.bounded_by_body = true;
  RelaxOptions falling;
  falling.max_iterations = 200;
  const auto run = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::vector<Vec3> x = model.start;
    relax(model, closing, x);
    relax(model, falling, x);
    return x;
  };
  const std::vector<Vec3> one = run(1);
  const std::vector<Vec3> two = run(2);
  EXPECT_TRUE(one == two);
  EXPECT_TRUE(one == run(2));
  EXPECT_FALSE(one == model.start);
}

INSTANTIATE_TEST_SUITE_P(Relax, SameBits,
                         testing::Values(BodyContactTerm::nodes, BodyContactTerm::faces));

TEST(Relax, AtRestItStaysAtRest) {
  // A flat sheet without weight has no force.
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 10, 10));
  const GarmentModel model = compile(garment, {}, garment.placed);
  std::vector<Vec3> x = model.start;
  RelaxOptions options;
  options.gravity = 0;
  options.max_iterations = 100;
  options.stop_median = options.stop_rms = 1e-6;
  const RelaxReport report = relax(model, options, x);
  EXPECT_TRUE(report.converged);
  for (std::size_t n = 0; n < x.size(); ++n) EXPECT_LT((x[n] - model.start[n]).norm(), 1e-12);
}

/// A sheet that stands upright on the floor is almost at rest until it falls over. Then it takes
/// longer to come as near to rest again. The run must not give it up.
TEST(Relax, WhatFallsOutOfABalanceIsNotGivenUp) {
  const Collider floor(test::box({-0.3, -0.1, -0.3}, {0.3, 0, 0.3}));
  PanelMesh garment;
  test::add_panel(garment, "sheet", test::grid(0.1, 0.04, 10, 4),
                  [](const Vec2& p) { return Vec3(p.x() - 0.05, 0.002 + p.y(), 0.01 * p.y()); });
  Scene scene;
  scene.collider = &floor;
  scene.body_contact = BodyContactTerm::nodes;
  scene.fabric.bending_warp = scene.fabric.bending_weft = 1e-3;
  scene.fabric.friction_skin = 0;
  const GarmentModel model = compile(garment, scene, garment.placed);
  std::vector<Vec3> x = model.start;
  RelaxOptions options;
  options.max_iterations = 40000;
  options.stop_median = options.stop_rms = 1e-6;
  options.patience = 1500;
  const RelaxReport report = relax(model, options, x);
  EXPECT_TRUE(report.converged);
  for (const Vec3& p : x) ASSERT_NEAR(p.y(), 0.002, 2e-5);
}

TEST(Relax, TheCountIsNoConvergence) {
  // A sheet in free fall does not come to rest.
  const PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 10, 10));
  const GarmentModel model = compile(garment, {}, garment.placed);
  std::vector<Vec3> x = model.start;
  RelaxOptions options;
  options.max_iterations = 120;
  options.stop_median = options.stop_rms = 0.5;
  const RelaxReport report = relax(model, options, x);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 120);
  // Inner nodes weigh more than the mean, for those on the border carry less cloth.
  EXPECT_NEAR(report.residual.median, 121.0 / 100, 1e-3);
}

}  // namespace relax_test
}  // namespace toile
