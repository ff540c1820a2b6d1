#include "cloth/relaxation/multilevel_preconditioner.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"
#include "tests/support/tubes.h"

namespace toile {
namespace multilevel_preconditioner_test {

/// Cuts each triangle into four, in the order that PanelMesh states.
PlanarMesh subdivided(PlanarMesh mesh) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), mesh.points.size());
    if (is_new) mesh.points.push_back(0.5 * (mesh.points[a] + mesh.points[b]));
    return at->second;
  };
  std::vector<Triangle> fine;
  for (const Triangle& t : mesh.triangles) {
    const int m01 = middle(t[0], t[1]), m12 = middle(t[1], t[2]), m20 = middle(t[2], t[0]);
    fine.insert(fine.end(),
                {{t[0], m01, m20}, {m01, t[1], m12}, {m20, m12, t[2]}, {m01, m12, m20}});
  }
  mesh.triangles = std::move(fine);
  return mesh;
}

TEST(MultilevelPreconditioner, MovesPatchesByTheForcesOnThem) {
  PanelMesh garment = test::flat_panel(subdivided(subdivided(test::grid(0.4, 0.4, 4, 4))));
  garment.subdivisions = 2;
  const GarmentModel model = compile(garment, {}, garment.placed);
  MultilevelPreconditioner motion(model, false);
  EXPECT_EQ(motion.levels(), 2);
  Vec4s forces;
  for (const double mass : model.mass) forces.push_back(Vec4{0, -9.81 * mass, 0, 0});
  motion.compute(forces, 1);
  EXPECT_NEAR(motion.rms_acceleration(), 9.81, 1e-9);
  // Two nodes of a patch that push each other apart do not move it; here, two corners of a child.
  forces.assign(model.nodes, Vec4{});
  const Triangle inner = model.node_triangles[3];
  forces[inner[0]] = Vec4{0, 0, 1, 0};
  forces[inner[1]] = Vec4{0, 0, -1, 0};
  motion.compute(forces, 1);
  EXPECT_LT(motion.rms_acceleration(), 0.51 / model.mass[inner[0]] / 16);
  // A force on a node moves the nodes of other patches linearly: halfway, half as far.
  forces.assign(model.nodes, Vec4{});
  const int centre = 2 * 5 + 2;  // of the coarsest mesh, whose points come first
  forces[centre] = Vec4{0, 0, 1, 0};
  motion.compute(forces, 1);
  EXPECT_GT(motion.of_node(centre)[2], 0);
  EXPECT_EQ(motion.of_node(0)[2], 0);
  for (const Vec2& p : {Vec2(0.15, 0.2), Vec2(0.2, 0.15)}) {
    for (int n = 0; n < model.nodes; ++n) {
      if ((garment.flat[n] - p).norm() > 1e-9) continue;
      // Half of the coarsest patch's displacement; none of the middle level's.
      EXPECT_GT(motion.of_node(n)[2], 0.2 * motion.of_node(centre)[2]);
      EXPECT_LT(motion.of_node(n)[2], 0.5 * motion.of_node(centre)[2]);
    }
  }
}

TEST(MultilevelPreconditioner, MovesWiderPatchesThanTheNestedMeshHas) {
  PanelMesh garment = test::flat_panel(subdivided(subdivided(test::grid(0.4, 0.4, 4, 4))));
  garment.subdivisions = 2;
  const GarmentModel model = compile(garment, {}, garment.placed);
  MultilevelPreconditioner wide(model, true);
  MultilevelPreconditioner nested(model, false);
  EXPECT_EQ(wide.nested_levels(), 2);
  EXPECT_EQ(wide.levels(), 4);
  const auto ways = [&](MultilevelPreconditioner& motion, int pushed) {
    Vec4s forces(model.nodes, Vec4{});
    forces[pushed] = Vec4{0, 0, 1, 0};
    motion.compute(forces, 1);
    std::vector<double> each;
    for (int n = 0; n < model.nodes; ++n) each.push_back(motion.of_node(n)[2]);
    return each;
  };
  const int centre = 2 * 5 + 2;  // of the coarsest mesh, whose points come first
  const std::vector<double> of_centre = ways(wide, centre);
  const std::vector<double> nested_of_centre = ways(nested, centre);
  // The corner is beyond the nested patches around the middle.
  EXPECT_EQ(nested_of_centre[0], 0);
  EXPECT_GT(of_centre[0], 0);
  for (int n = 0; n < model.nodes; ++n) {
    EXPECT_GE(of_centre[n], nested_of_centre[n]);
    EXPECT_LE(of_centre[n], of_centre[centre]);
  }
  // The weights that restrict forces to patches also interpolate displacements to nodes.
  for (const int other : {0, 7, model.nodes / 2, model.nodes - 1}) {
    EXPECT_NEAR(ways(wide, other)[centre], of_centre[other], 1e-12 * of_centre[centre]);
  }
}

/// A strip over a bar along x, whose ends are swung out by some degrees at the start.
TEST(MultilevelPreconditioner, BringsWideMotionsToRestInFewerIterations) {
  const double radius = 0.03, length = 0.64, out = radius + 0.002;
  TriangleMesh bar = test::closed_tube(radius, radius, 0.3, 100);
  for (Vec3& p : bar.points) p = Vec3(p.y() - 0.15, -p.x(), p.z());
  const Collider body{bar};
  PanelMesh garment;
  test::add_panel(garment, "strip", subdivided(subdivided(test::grid(0.16, length, 4, 16))),
                  [&](const Vec2& p) {
                    const double s = p.y() - length / 2;
                    const double arc =
                        std::clamp(s, -out * std::numbers::pi / 2, out * std::numbers::pi / 2);
                    const double hanging = std::abs(s) - std::abs(arc);
                    return Vec3(p.x() - 0.08, out * std::cos(arc / out) - 0.99 * hanging,
                                out * std::sin(arc / out) + (s > 0 ? 0.14 : -0.14) * hanging);
                  });
  Scene scene;
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  scene.self_contact = false;
  RelaxOptions options;
  options.max_iterations = 60000;
  options.stop_median = options.stop_rms = 1e-3;
  std::vector<Vec3> rests[2];
  int iterations[2];
  for (const int subdivisions : {0, 2}) {
    garment.subdivisions = subdivisions;
    const GarmentModel model = compile(garment, scene, garment.placed);
    std::vector<Vec3> x = model.start;
    const RelaxReport report = relax(model, options, x);
    EXPECT_TRUE(report.converged);
    std::cout << subdivisions << " coarser levels: " << report.iterations << " iterations\n";
    rests[subdivisions / 2] = x;
    iterations[subdivisions / 2] = report.iterations;
  }
  EXPECT_LT(iterations[1], 0.6 * iterations[0]);
  double farthest = 0;
  for (std::size_t n = 0; n < rests[0].size(); ++n) {
    farthest = std::max(farthest, (rests[0][n] - rests[1][n]).norm());
  }
  std::cout << "rests " << 1000 * farthest << " mm apart\n";
  EXPECT_LT(farthest, 0.001);
}

/// Where all of a sheet is in contact, each level would take the whole stiffness of contact for its
/// step alone. But the steps of all levels add up.
TEST(MultilevelPreconditioner, SoftClothComesToRestOnWhatItTouches) {
  const Collider body{test::box({-0.3, -0.1, -0.3}, {0.3, 0, 0.3})};
  PanelMesh garment;
  test::add_panel(garment, "sheet", subdivided(subdivided(test::grid(0.2, 0.2, 4, 4))),
                  [](const Vec2& p) { return Vec3(p.x() - 0.1, 0.0025, 0.1 - p.y()); });
  garment.subdivisions = 2;
  Scene scene;
  scene.collider = &body;
  scene.body_contact = BodyContactTerm::nodes;
  scene.fabric = find_fabric("jersey");
  const GarmentModel model = compile(garment, scene, garment.placed);
  std::vector<Vec3> x = model.start;
  RelaxOptions options;
  options.max_iterations = 4000;
  options.stop_median = options.stop_rms = 1e-3;
  const RelaxReport report = relax(model, options, x);
  std::cout << report.iterations << " iterations, residual " << report.residual.rms << "\n";
  EXPECT_TRUE(report.converged);
}

}  // namespace multilevel_preconditioner_test
}  // namespace toile
