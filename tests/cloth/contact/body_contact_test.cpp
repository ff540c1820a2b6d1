#include "cloth/contact/body_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <utility>

#include "cloth/contact/constants.h"
#include "cloth/scene/collider.h"
#include "geometry/distance_grid.h"
#include "tests/support/shapes.h"

namespace toile {
namespace body_contact_test {

constexpr double offset = 0.006;

/// Two walls less than twice the offset apart, as arm and chest may be.
class Crevice : public testing::Test {
 protected:
  static constexpr double half_width = 0.004;

  Crevice() { scene.collider = &grid; }

  /// The push (N) on a vertex at `x` metres across the crevice, and the bound of its stiffness
  /// (N/m).
  struct Push {
    double force;
    double stiffness;
  };
  Push push_at(double x) const {
    const Vec3 p(x, 0.003, 0.001);
    BodyContact contact;
    contact.linearize(scene, p, offset, 2e-4, 0, true);
    Vec4 force = {0, 0, 0, 0};
    Push push = {};
    contact.add(as_vec4(p), 0, force, push.stiffness);
    push.force = force[0];
    return push;
  }

  const Collider grid{test::together(test::box({-0.1, -0.1, -0.1}, {-half_width, 0.1, 0.1}),
                                     test::box({half_width, -0.1, -0.1}, {0.1, 0.1, 0.1}))};
  Scene scene;
};

/// Otherwise a vertex in the middle would be thrown from side to side without end.
TEST_F(Crevice, TheFartherFromItsMiddleTheHarderItPushesBack) {
  constexpr double step = 2e-5;
  double largest_jump = 0;
  double stiffest = 0;
  Push before = push_at(-0.003);
  const double at_wall = before.force;
  EXPECT_GT(at_wall, 0);
  for (double x = -0.003 + step; x < 0.003; x += step) {
    const Push here = push_at(x);
    const double slope = (before.force - here.force) / step;
    stiffest = std::max(stiffest, slope / here.stiffness);
    largest_jump = std::max(largest_jump, before.force - here.force);
    before = here;
  }
  std::cout << "largest jump " << largest_jump << " N of " << at_wall << ", stiffness " << stiffest
            << " of the bound\n";
  EXPECT_LT(largest_jump, 0.05 * at_wall);
  EXPECT_LT(stiffest, 1.05);
  EXPECT_GT(stiffest, 0.3) << "the bound says nothing";
}

TEST(BodyContact, ADeepVertexIsPushedFirmly) {
  const Collider wall{test::box({-0.1, -0.1, -0.1}, {0.1, 0.0, 0.1})};
  Scene scene;
  scene.collider = &wall;
  /// The push (N) at a depth below the offset, and the bound of its stiffness (N/m).
  const auto push_at = [&](double depth) {
    const Vec3 p(0.003, offset - depth, 0.001);
    BodyContact contact;
    contact.linearize(scene, p, offset, 1.5e-5, 0, true);
    Vec4 force = {0, 0, 0, 0};
    double stiffness = 0;
    contact.add(as_vec4(p), 0, force, stiffness);
    return std::pair(force[1], stiffness);
  };
  const auto shallow = push_at(0.5 * firm_depth);
  EXPECT_NEAR(shallow.first, body_push_stiffness * 0.5 * firm_depth, 1e-2 * shallow.first);
  const auto deep = push_at(3 * firm_depth);
  EXPECT_NEAR(deep.first, body_push_stiffness * firm_depth * (1 + 2 * firm_push_factor),
              1e-2 * deep.first);
  EXPECT_GE(deep.second, 0.99 * firm_push_factor * body_push_stiffness);
  // It grows without a jump.
  const auto before = push_at(firm_depth - 1e-6);
  const auto after = push_at(firm_depth + 1e-6);
  EXPECT_NEAR(before.first, after.first, 2e-6 * firm_push_factor * body_push_stiffness);
}

}  // namespace body_contact_test
}  // namespace toile
