#include "cloth/relaxation/edge_contacts.h"

#include <gtest/gtest.h>

#include "geometry/distance_grid.h"
#include "tests/support/shapes.h"

namespace toile {
namespace {

/// What holds a coarse mesh by the middles of its edges goes on to hold it in the next run: else it
/// sags until they have taken hold anew.
TEST(EdgeContacts, HoldOnFromRunToRun) {
  const DistanceGrid body{BodyDistance(test::box({-0.2, -0.1, -0.2}, {0.2, 0, 0.2}))};
  Scene scene;
  scene.body = &body;
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const auto at = [](double way) {
    const double height = 0.002 - 1e-5;
    return as_vec4(
        {Vec3(way, height, 0), {0.03 + way, height, 0}, {0.05 + way, height + 0.01, 0.002}});
  };
  const auto pull = [&](EdgeContacts& contacts, double way) {
    Vec4s force(3, Vec4{});
    contacts.look_anew();
    contacts.add(scene, ForceOptions{}, at(way), force);
    return force[0][0] + force[1][0] + force[2][0];
  };
  EdgeContacts contacts(triangles, at(0), 0.025, {0.4, 0.4, 0.4});
  EXPECT_NEAR(pull(contacts, 0), 0, 1e-9);
  const double held = pull(contacts, 1e-5);
  EXPECT_NEAR(held, -200 * 1e-5, 1e-5);
  const std::vector<EdgeGrip> grips = contacts.grips();
  ASSERT_EQ(grips.size(), 1U);
  EXPECT_EQ(grips[0].edge, (std::array<int, 2>{0, 1}));
  EdgeContacts next(triangles, at(1e-5), 0.025, {0.4, 0.4, 0.4});
  next.hold(grips);
  EXPECT_NEAR(pull(next, 1e-5), held, 1e-12);
}

}  // namespace
}  // namespace toile
