#include "cloth/dressing/coupled_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numbers>
#include <numeric>

#include "cloth/model/compile.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"
#include "tests/support/shapes.h"

namespace toile {
namespace coupled_layers_test {

constexpr double pi = std::numbers::pi;
constexpr double height = 0.06, bending = 2e-3;

/// An upright tube of cloth that is `girth` around when flat and stands on the floor at `radius`
/// from the axis.
PanelMesh tube(double girth, double radius, int columns, int rows) {
  PanelMesh garment;
  test::add_panel(garment, "tube", test::grid(girth, height, columns, rows), [&](const Vec2& p) {
    const double angle = 2 * pi * p.x() / girth;
    return Vec3(radius * std::sin(angle), 0.002 + p.y(), radius * std::cos(angle));
  });
  garment.seams = {test::seam("", test::side(garment.panels[0], columns, rows, false),
                              test::side(garment.panels[0], columns, rows, true))};
  return garment;
}

double girth_of(const std::vector<Vec3>& nodes, int columns, int row) {
  double girth = 0;
  for (int i = 0; i < columns; ++i) {
    girth += (nodes[row * columns + i] - nodes[row * columns + (i + 1) % columns]).norm();
  }
  return girth;
}

/// Two tubes on a floor, one around the other.
class TwoTubes : public testing::Test {
 protected:
  TwoTubes() {
    scene.collider = &floor;
    scene.body_contact = BodyContactTerm::nodes;
    scene.fabric.friction_skin = 0;
    options.max_iterations = 5000;
    options.stop_median = options.stop_rms = 0.1;
  }

  WornGarment wear(const PanelMesh& garment, double stiffness) const {
    WornGarment worn;
    worn.garment = &garment;
    worn.fabric.stretch_warp = worn.fabric.stretch_weft = stiffness;
    worn.fabric.shear = 20;
    worn.fabric.bending_warp = worn.fabric.bending_weft = bending;
    worn.fabric.friction_skin = worn.fabric.friction_cloth = 0;
    worn.nodes = compile(garment, scene, garment.placed).start;
    worn.body_offset = 0.002;
    return worn;
  }

  const Collider floor{test::box({-0.3, -0.1, -0.3}, {0.3, 0, 0.3})};
  Scene scene;
  DressOptions options;
};

/// Case 8 of Laplace for two: the pressures T/R of both sum to none, so what one is stretched with
/// the other is compressed with.
TEST_F(TwoTubes, TheOuterOneCompressesTheInnerOne) {
  // Other columns, so that their edges don't lie along each other.
  const int inner_columns = 96, inner_rows = 4, outer_columns = 80, outer_rows = 3;
  const double radius = 0.1, inner_stiffness = 60, outer_stiffness = 40;
  const double inner_girth = 2 * pi * radius, outer_girth = 0.95 * inner_girth;
  const PanelMesh inner = tube(inner_girth, radius, inner_columns, inner_rows);
  const PanelMesh outer = tube(outer_girth, radius + 0.0025, outer_columns, outer_rows);
  const std::vector<WornGarment> worn = {wear(inner, inner_stiffness),
                                         wear(outer, outer_stiffness)};
  const CoupledResult result = relax_coupled(worn, scene, options);
  EXPECT_TRUE(result.stages.back().converged);
  ASSERT_EQ(result.nodes.size(), 2U);
  EXPECT_TRUE(intersections({result.nodes[0], compile(inner, scene, inner.placed).node_triangles},
                            {result.nodes[1], compile(outer, scene, outer.placed).node_triangles})
                  .empty());

  // Girths: G2 = G1 + 2 pi gap. The quadratic model of bending draws a tube together like a tension
  // of B/R². So k1 (G1/L1 - 1) + k2 (G2/L2 - 1) + 2 B/R² = 0.
  const double apart = 2 * pi * scene.self_gap;
  const double bent = bending / (radius * radius);
  const double girth =
      (inner_stiffness + outer_stiffness - 2 * bent - outer_stiffness * apart / outer_girth) /
      (inner_stiffness / inner_girth + outer_stiffness / outer_girth);
  const double inner_strain = girth / inner_girth - 1;
  const double outer_strain = (girth + apart) / outer_girth - 1;
  EXPECT_LT(inner_strain, -0.01) << "it has to be squeezed for this to say anything";
  double worst = 0;
  const auto expect_strain = [&](double strain, double expected, const std::string& where) {
    worst = std::max(worst, std::abs(strain / expected - 1));
    EXPECT_NEAR(strain, expected, 0.03 * std::abs(expected)) << where;
  };
  for (int row = 1; row < inner_rows; ++row) {
    expect_strain(girth_of(result.nodes[0], inner_columns, row) / inner_girth - 1, inner_strain,
                  "inner row " + std::to_string(row));
  }
  for (int row = 1; row < outer_rows; ++row) {
    expect_strain(girth_of(result.nodes[1], outer_columns, row) / outer_girth - 1, outer_strain,
                  "outer row " + std::to_string(row));
  }
  const double way = (inner_girth - girth) / (2 * pi);
  EXPECT_NEAR(result.moved[0].median, way, 0.05 * way);

  // Over an angle of 1 the outer one presses with its tension.
  ASSERT_EQ(result.contacts.size(), 1U);
  const LayerContact& pressing = result.contacts[0];
  EXPECT_EQ(pressing.inner, 0);
  EXPECT_EQ(pressing.outer, 1);
  const double force = 2 * pi * height * (outer_stiffness * outer_strain + bent);
  EXPECT_NEAR(pressing.force, force, 0.05 * force);
  EXPECT_NEAR(pressing.area, inner_girth * height, 0.01 * inner_girth * height);
  std::cout << "inner strain " << 100 * inner_strain << " %, outer " << 100 * outer_strain
            << " %, largest error " << 100 * worst << " % of it; pressing " << pressing.force
            << " N of " << force << " N; residual " << result.stages.back().residual.median << ", "
            << result.stages.back().residual.rms << " after " << result.stages.back().steps
            << " steps; moved " << 1000 * result.moved[0].median << " mm of " << 1000 * way << "\n";
}

TEST_F(TwoTubes, TubesThatDoNotTouchStay) {
  const PanelMesh inner = tube(2 * pi * 0.08, 0.08, 48, 4);
  const PanelMesh outer = tube(2 * pi * 0.1, 0.1, 48, 4);
  const CoupledResult result =
      relax_coupled({wear(inner, 1000), wear(outer, 1000)}, scene, options);
  EXPECT_TRUE(result.contacts.empty());
  for (const MoveStatistics& moved : result.moved) EXPECT_LT(moved.max, 1e-3);
}

TEST_F(TwoTubes, GarmentsThatIntersectAreRefused) {
  const PanelMesh one = tube(2 * pi * 0.1, 0.1, 48, 4);
  PanelMesh other = one;
  for (Vec3& p : other.placed) p.x() += 0.01;
  const std::vector<WornGarment> worn = {wear(one, 1000), wear(other, 1000)};
  EXPECT_HOLDS(samples::error_of([&] { relax_coupled(worn, scene, options); }), "intersect");
}

TEST_F(TwoTubes, GarmentsKeepTheirFabrics) {
  PanelMesh one = tube(2 * pi * 0.1, 0.1, 48, 4);
  PanelMesh other = tube(2 * pi * 0.12, 0.12, 48, 4);
  other.panels[0].fabric = "heavy";
  other.elastics = {{"waist", {3, 4}, 0.5, 20}};
  scene.fabrics["heavy"].areal_density = 3;
  const std::vector<WornGarment> worn = {wear(one, 1000), wear(other, 1000)};
  const PanelMesh all = join_garments(worn);
  ASSERT_EQ(all.panels.size(), 2U);
  EXPECT_EQ(all.panels[0].fabric, garment_fabric(0));
  EXPECT_EQ(all.panels[1].fabric, "heavy");
  EXPECT_EQ(all.panels[1].first_point, one.panels[0].points);
  EXPECT_EQ(all.triangles.size(), one.triangles.size() + other.triangles.size());
  EXPECT_EQ(all.seams[1].a[0], other.seams[0].a[0] + static_cast<int>(one.flat.size()));
  ASSERT_EQ(all.elastics.size(), 1U);
  EXPECT_EQ(all.elastics[0].points[0], static_cast<int>(one.flat.size()) + 3);
  scene.fabrics.clear();
  EXPECT_HOLDS(samples::error_of([&] { relax_coupled(worn, scene, options); }), "heavy");
}

TEST_F(TwoTubes, WhatIsAttachedForGoodStaysSo) {
  const int columns = 48;
  const PanelMesh inner = tube(2 * pi * 0.08, 0.08, columns, 4);
  const PanelMesh outer = tube(2 * pi * 0.1, 0.1, columns, 4);
  std::vector<WornGarment> worn = {wear(inner, 1000), wear(outer, 1000)};
  // The outer one is held 2 cm up, all around its middle.
  const double weight = 2 * pi * 0.1 * height * worn[1].fabric.areal_density * 9.81;
  for (int i = 0; i < columns; ++i) {
    const int point = 2 * (columns + 1) + i;
    worn[1].attached.push_back({point, 0, outer.placed[point] + Vec3(0, 0.02, 0), Vec3::UnitY(), 5,
                                1.5 * weight / columns, true});
  }
  const CoupledResult result = relax_coupled(worn, scene, options);
  double low = 1e9;
  for (const Vec3& p : result.nodes[1]) low = std::min(low, p.y());
  EXPECT_NEAR(low, 0.022 - weight / columns / 5, 0.002);
  for (const Vec3& p : result.nodes[0]) EXPECT_LT(p.y(), 0.002 + height + 1e-3);
}

/// A strip of 10 cm stands upright, held by its lower end. It is more than twice as long as it can
/// be [Greenhill 1881], but nothing says which side it falls to. Released, it moves off, and its
/// rest after that counts.
TEST_F(TwoTubes, WhatStandsOnASaddleFallsWhenLetGo) {
  constexpr double length = 0.1, off = 1e-6;
  const PanelMesh outer = tube(2 * pi * 0.1, 0.1, 48, 4);
  PanelMesh strip = test::flat_panel(test::grid(0.02, length, 2, 10));
  for (Vec3& p : strip.placed) p += Vec3(0, 0.002, off * std::pow(p.y() / length, 2));
  std::vector<WornGarment> worn = {wear(strip, 1000), wear(outer, 1000)};
  worn[0].fabric = Fabric{};
  for (int point = 0; point < 6; ++point) {
    worn[0].attached.push_back({point, 0, strip.placed[point], Vec3::UnitY(), 1000, 8, true});
  }
  const auto highest = [](const std::vector<Vec3>& nodes) {
    double most = -1;
    for (const Vec3& p : nodes) most = std::max(most, p.y());
    return most;
  };
  options.stop_median = options.stop_rms = 0.01;
  EXPECT_GT(highest(relax_coupled(worn, scene, options).nodes[0]), 0.9 * length);

  options.release_seconds = 2;
  const CoupledResult fallen = relax_coupled(worn, scene, options);
  ASSERT_TRUE(fallen.release);
  EXPECT_TRUE(fallen.release->stays());
  EXPECT_TRUE(fallen.stages.back().converged);
  EXPECT_LT(highest(fallen.nodes[0]), 0.5 * length);
  EXPECT_LT(highest(fallen.nodes[1]), 0.002 + height + 1e-3);
}

/// A sheet lies over a spike that is finer than its mesh and would pass between its nodes. It is
/// held off the spike, and a sheet on the floor is not: each garment has its own extra offset.
TEST(CoupledRelaxation, EachGarmentHasItsOwnExtraOffset) {
  const Collider body{test::together(test::box({-0.2, -0.05, -0.2}, {0.6, 0, 0.2}),
                                     test::spike(0, 0, 0.005, 0.06))};
  const auto sheet = [](double x, double y) {
    PanelMesh garment;
    test::add_panel(garment, "sheet", test::grid(0.2, 0.2, 8, 8), [=](const Vec2& p) {
      return Vec3(x + p.x() - 0.1 + 0.003, y, p.y() - 0.1 + 0.002);
    });
    return garment;
  };
  const std::vector<PanelMesh> garments = {sheet(0.4, 0.004), sheet(0, 0.062)};
  Scene scene;
  scene.collider = &body;
  std::vector<WornGarment> worn(2);
  for (std::size_t i = 0; i < worn.size(); ++i) {
    worn[i].garment = &garments[i];
    worn[i].nodes = compile(garments[i], scene, garments[i].placed).start;
    worn[i].body_offset = 0.002;
  }
  DressOptions options;
  options.max_iterations = 1500;
  const CoupledResult result = relax_coupled(worn, scene, options);
  ASSERT_EQ(result.extra_offset.size(), 2u);
  const auto lifted = [&](std::size_t i) {
    EXPECT_EQ(result.extra_offset[i].size(), worn[i].nodes.size());
    return std::count_if(result.extra_offset[i].begin(), result.extra_offset[i].end(),
                         [](double metres) { return metres > 0; });
  };
  EXPECT_EQ(lifted(0), 0);
  EXPECT_GT(lifted(1), 0);
  for (std::size_t n = 0; n < result.extra_offset[1].size(); ++n) {
    if (result.extra_offset[1][n] > 0) {
      EXPECT_LT(std::hypot(result.nodes[1][n].x(), result.nodes[1][n].z()), 0.08);
    }
  }
}

}  // namespace coupled_layers_test
}  // namespace toile
