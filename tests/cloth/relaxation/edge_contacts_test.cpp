#include "cloth/relaxation/edge_contacts.h"

#include <gtest/gtest.h>

#include "cloth/dressing/coupled_layers.h"
#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"

namespace toile {
namespace edge_contacts_test {

/// Anchors at the middles of the edges go on holding a coarse mesh in the next run. Otherwise the
/// mesh would sag until it has new anchors.
TEST(EdgeContacts, HoldOnFromRunToRun) {
  const Collider body{test::box({-0.2, -0.1, -0.2}, {0.2, 0, 0.2})};
  Scene scene;
  scene.collider = &body;
  GarmentModel model;
  model.scene = scene;
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const auto at = [](double displacement) {
    const double height = 0.002 - 1e-5;
    return as_vec4({Vec3(displacement, height, 0),
                    {0.03 + displacement, height, 0},
                    {0.05 + displacement, height + 0.01, 0.002}});
  };
  const auto pull = [&](EdgeContacts& contacts, double displacement) {
    Vec4s force(3, Vec4{});
    contacts.forget();
    contacts.push(0, contacts.edges(), model, ForceOptions{}, at(displacement));
    contacts.add(0, force.size(), force);
    return force[0][0] + force[1][0] + force[2][0];
  };
  EdgeContacts contacts(triangles, at(0), 0.025, {0.4, 0.4, 0.4}, {0, 0, 0});
  EXPECT_NEAR(pull(contacts, 0), 0, 1e-9);
  const double held = pull(contacts, 1e-5);
  EXPECT_NEAR(held, -200 * 1e-5, 1e-5);
  const std::vector<EdgeAnchor> anchors = contacts.anchors();
  ASSERT_EQ(anchors.size(), 1U);
  EXPECT_EQ(anchors[0].edge, (std::array<int, 2>{0, 1}));
  EdgeContacts next(triangles, at(1e-5), 0.025, {0.4, 0.4, 0.4}, {0, 0, 0});
  next.set_anchors(anchors);
  EXPECT_NEAR(pull(next, 1e-5), held, 1e-12);
}

/// Heavy sheets of 5 cm edges rest on a slope. Of the 49 anchors of each, 33 are at the middles of
/// edges.
class CoarseOnASlope : public testing::Test {
 protected:
  CoarseOnASlope() {
    scene.collider = &body;
    scene.gravity = 9.81 * Vec3(std::sin(0.2), -std::cos(0.2), 0);
    scene.fabric.areal_density = 1;
    scene.fabric.friction_skin = 0.4;
    options.bounded = true;
    options.stop_median = options.stop_rms = 1e-4;
  }

  static PanelMesh sheet(double left) {
    PanelMesh garment;
    test::add_panel(garment, "sheet", test::grid(0.15, 0.15, 3, 3),
                    [&](const Vec2& p) { return Vec3(left + p.x(), 0.0021, -p.y()); });
    return garment;
  }

  WornGarment worn(const PanelMesh& garment) {
    const GarmentModel model = compile(garment, scene, garment.placed);
    WornGarment worn{&garment, scene.fabric, model.start, {}, 0.002};
    const RelaxReport report = relax(model, options, worn.nodes);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.warm_start.edge_anchors.size(), 33U);
    worn.warm_start = report.warm_start;
    return worn;
  }

  const Collider body{test::box({-0.3, -0.1, -0.3}, {0.3, 0, 0.3})};
  Scene scene;
  RelaxOptions options;
};

TEST_F(CoarseOnASlope, IsAtRestInTheNextRun) {
  const PanelMesh garment = sheet(-0.1);
  WornGarment rested = worn(garment);
  options.warm_start = &rested.warm_start;
  options.max_iterations = 1;
  std::vector<Vec3> x = rested.nodes;
  const RelaxReport again = relax(compile(garment, scene, garment.placed), options, x);
  std::cout << "residual in the next run: " << again.residual.rms << "\n";
  EXPECT_LT(again.residual.rms, 2e-4);
}

TEST_F(CoarseOnASlope, IsAtRestWithOthers) {
  const std::array<PanelMesh, 2> garments = {sheet(-0.25), sheet(0.05)};
  DressOptions together;
  together.stop_median = together.stop_rms = 1e-4;
  const CoupledResult result =
      relax_coupled({worn(garments[0]), worn(garments[1])}, scene, together);
  for (const MoveStatistics& moved : result.moved) {
    std::cout << "moved by " << 1e6 * moved.max << " micrometres\n";
    EXPECT_LT(moved.max, 1e-7);
  }
}

}  // namespace edge_contacts_test
}  // namespace toile
