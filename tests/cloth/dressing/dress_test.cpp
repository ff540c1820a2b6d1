#include "cloth/dressing/dress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace dress_test {

/// Two squares of 20 cm that are sewn along one side, above a box.
PanelMesh two_squares() {
  const std::string square = "[0,0],[20,0],[20,20],[0,20]";
  std::vector<Remark> remarks;
  const Pattern pattern = samples::parse(
      samples::file(samples::polygon("left", square) + "," + samples::polygon("right", square),
                    R"([{"panel": "left", "edge": 1}, {"panel": "right", "edge": 3}])"));
  check_pattern(pattern, remarks);
  PanelMesh mesh = mesh_panels(pattern, {.edge_length = 0.01}, remarks);
  for (const MeshedPanel& panel : mesh.panels) {
    const double shift = panel.name == "left" ? -0.205 : 0.005;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      mesh.placed[p] = Vec3(mesh.flat[p].x() + shift, 0.01, 0.1 - mesh.flat[p].y());
    }
  }
  return mesh;
}

TEST(Dress, ProgressGoesFromNothingToAllAndNeverBack) {
  const PanelMesh garment = two_squares();
  ASSERT_GT(garment.subdivisions, 0);
  const Collider body{test::box({-0.3, -0.1, -0.2}, {0.3, 0, 0.2})};
  Scene scene;
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  std::set<std::string> stages;
  std::set<const PanelMesh*> meshes;
  std::vector<double> progress;
  DressOptions options;
  options.max_iterations = 400;
  const DressResult result = dress(garment, scene, options, [&](const DressFrame& frame) {
    stages.insert(frame.stage);
    meshes.insert(&frame.mesh);
    progress.push_back(frame.progress);
  });
  EXPECT_EQ(stages,
            (std::set<std::string>{"position", "close_seams", "untangle", "settle", "rest"}));
  EXPECT_GT(meshes.size(), 1U);
  EXPECT_EQ(progress.front(), 0);
  EXPECT_EQ(progress.back(), 1);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  // Not all of it at once.
  for (std::size_t i = 1; i < progress.size(); ++i) {
    EXPECT_LT(progress[i] - progress[i - 1], 0.5) << i;
  }
}

/// The seams that are tight on a tube of `around` metres, dressed on one of 62.8 cm.
std::vector<TightSeam> tight_on_a_tube(double around) {
  constexpr int columns = 12, rows = 4;
  const Collider body(test::closed_tube(0.1, 0.1, 2, 64));
  PanelMesh garment;
  for (const int half : {0, 1}) {
    test::add_panel(garment, half == 0 ? "front" : "back",
                    test::grid(around / 2, 0.15, columns, rows), [&](const Vec2& p) {
                      const double angle = std::numbers::pi * (half + 2 * p.x() / around);
                      const double radius = std::max(0.104, around / (2 * std::numbers::pi));
                      return Vec3(radius * std::sin(angle), 1 + p.y(), radius * std::cos(angle));
                    });
  }
  garment.seams = test::side_seams(garment, columns, rows);
  Scene scene;
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  scene.fabric.stretch_warp = scene.fabric.stretch_weft = 200;
  scene.fabric.shear = 40;
  scene.gravity = Vec3::Zero();
  DressOptions options;
  options.max_iterations = 2000;
  return dress(garment, scene, options).tight_seams;
}

TEST(Dress, TheSeamsOfATubeCutTooSmallAreTight) {
  const std::vector<TightSeam> tight = tight_on_a_tube(0.47);
  ASSERT_EQ(tight.size(), 2U);
  // The inner face is as long as the body's girth, though the cloth lies 2 mm off.
  const double girth = 2 * std::numbers::pi * 0.1;
  EXPECT_NEAR(tight[0].missing + tight[1].missing, girth - 0.47, 0.001);
  EXPECT_NEAR(tight[0].tension, 200 * (girth / 0.47 - 1), 2);
  EXPECT_TRUE(tight_on_a_tube(0.58).empty());  // 10 % of stretch are worn
}

// Two panels whose seams stand on either side of a wall of 20 cm.
TEST(Dress, WhatTheBodyHoldsApartStaysOpenAndClearOfIt) {
  constexpr int columns = 8, rows = 8;
  const TriangleMesh wall = test::box({-1, 0, -0.1}, {1, 2, 0.1});
  const Collider body(wall);
  PanelMesh garment;
  for (const double side : {1, -1}) {
    test::add_panel(
        garment, side > 0 ? "front" : "back", test::grid(0.1, 0.15, columns, rows),
        [&](const Vec2& p) { return Vec3(side * (p.x() - 0.05), 1 + p.y(), side * 0.16); });
  }
  garment.seams = test::side_seams(garment, columns, rows);
  Scene scene;
  scene.collider = &body;
  scene.gravity = Vec3::Zero();
  DressOptions options;
  options.max_iterations = 2000;
  const DressResult result = dress(garment, scene, options);
  EXPECT_TRUE(intersections({result.nodes, result.triangles}, wall).empty());
  const std::vector<Vec3> points = material_points(garment, result);
  for (const MeshedSeam& seam : garment.seams) {
    double gap = 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      gap = std::max(gap, (points[seam.a[i]] - points[seam.b[i]]).norm());
    }
    EXPECT_GE(gap, 0.2) << seam.name;
  }
}

/// A sheet beside the body, 3 cm above the floor.
std::vector<Vec3> fallen_sheet(bool has_floor) {
  const Collider body{test::box({-0.1, 0, -0.1}, {0.1, 0.5, 0.1})};
  PanelMesh garment = test::flat_panel(test::grid(0.1, 0.1, 4, 4));
  for (Vec3& p : garment.placed) p = Vec3(0.5 + p.x(), 0.03, p.y());
  Scene scene;
  scene.collider = &body;
  if (has_floor) scene.floor = 0;
  DressOptions options;
  options.max_iterations = 2000;
  return dress(garment, scene, options).nodes;
}

TEST(Dress, WhatFallsLiesOnTheFloor) {
  for (const Vec3& p : fallen_sheet(true)) {
    EXPECT_GT(p.y(), 0.001);
    EXPECT_LT(p.y(), 0.006);
  }
  for (const Vec3& p : fallen_sheet(false)) EXPECT_LT(p.y(), -0.01);
}

/// A strip of 10 cm is held upright by its lower end. It is more than twice as long as it can
/// stand, 3.8 cm [Greenhill 1881: (7.84 B / w)^(1/3)], but nothing says which side it falls to.
TEST(Dress, LeavesASaddleThatReleaseFinds) {
  constexpr double length = 0.1, off = 1e-6;
  PanelMesh garment = test::flat_panel(test::grid(0.02, length, 2, 10));
  for (Vec3& p : garment.placed) p.z() = off * std::pow(p.y() / length, 2);
  std::vector<int> clamped = {0, 1, 2, 3, 4, 5};
  for (const int point : clamped) {
    garment.attachments.push_back(
        {"point " + std::to_string(point),
         {point},
         {AttachedTo::point, "", 0, garment.placed[point], true, 1000, 8}});
  }
  const Collider far(test::box({2, 2, 2}, {3, 3, 3}));
  Scene scene;
  scene.collider = &far;
  scene.body_contact = BodyContactTerm::nodes;
  scene.self_contact = false;
  const auto highest = [](const DressResult& result) {
    double most = -1;
    for (const Vec3& p : result.nodes) most = std::max(most, p.y());
    return most;
  };
  DressOptions options;
  const DressResult standing = dress(garment, scene, options);
  EXPECT_TRUE(standing.converged);
  EXPECT_GT(highest(standing), 0.9 * length);

  options.release_seconds = 2;
  const DressResult fallen = dress(garment, scene, options);
  EXPECT_TRUE(fallen.converged);
  ASSERT_TRUE(fallen.release);
  EXPECT_TRUE(fallen.release->stays());
  EXPECT_LT(highest(fallen), 0.5 * length);
  EXPECT_GT(fallen.stages.size(), standing.stages.size());
}

}  // namespace dress_test
}  // namespace toile
