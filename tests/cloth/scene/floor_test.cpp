#include "cloth/scene/floor.h"

#include <gtest/gtest.h>

#include "cloth/contact/body_contact.h"
#include "cloth/scene/collider.h"
#include "tests/support/shapes.h"

namespace toile {
namespace floor_test {

constexpr double offset = 0.004;

TEST(Floor, LiesAtZeroOrUnderTheLowestPoint) {
  const Vec3 down(0, -9.81, 0);
  EXPECT_EQ(floor_below(test::box({-0.1, 0.02, -0.1}, {0.1, 1, 0.1}), down), 0);
  EXPECT_EQ(floor_below(test::box({-0.1, -0.02, -0.1}, {0.1, 1, 0.1}), down), -0.02);
}

TEST(Floor, ABodyThatLiesHasNone) {
  EXPECT_FALSE(floor_below(test::box({-0.1, 0, -0.1}, {0.1, 1, 0.1}), {-9.81, 0, 0}));
}

/// A box that stands on the floor, and one that hangs 2 mm above it.
class OnTheFloor : public testing::Test {
 protected:
  OnTheFloor() {
    scene.collider = &box;
    scene.floor = 0;
  }

  /// N: the push on a vertex at `p`.
  Vec3 push_at(const Vec3& p) const {
    BodyContact contact;
    contact.linearize(scene, p, offset, 2e-4, 0, false);
    Vec4 force = {0, 0, 0, 0};
    double stiffness = 0;
    contact.add(as_vec4(p), 0, force, stiffness);
    return as_vec3(force);
  }

  const Collider box{test::box({-0.1, 0.002, -0.1}, {0.1, 0.3, 0.1})};
  Scene scene;
};

TEST_F(OnTheFloor, ClothBesideTheBodyIsPushedUp) {
  const Vec3 push = push_at({0.5, 0.001, 0});
  EXPECT_GT(push.y(), 0);
  EXPECT_EQ(push.x(), 0);
  EXPECT_EQ(push_at({0.5, 2 * offset, 0}).norm(), 0);
}

TEST_F(OnTheFloor, WithoutOneNothingPushesThere) {
  scene.floor.reset();
  EXPECT_EQ(push_at({0.5, 0.001, 0}).norm(), 0);
}

TEST_F(OnTheFloor, TheBodyCountsWhereItIsNearer) {
  const Vec3 beside(0.101, 0.15, 0);
  const Vec3 push = push_at(beside);
  scene.floor.reset();
  EXPECT_EQ((push - push_at(beside)).norm(), 0);
  EXPECT_GT(push.x(), 0);
}

/// Otherwise cloth under a sole would be pressed from both sides without end.
TEST_F(OnTheFloor, ClothUnderASoleFindsRoom) {
  EXPECT_LT(push_at({0, 0.001, 0}).y(), 0);
  EXPECT_NEAR(push_at({0, 0.002 - offset, 0}).norm(), 0, 1e-3);
  EXPECT_GT(push_at({0, -0.05, 0}).y(), 0);
}

}  // namespace floor_test
}  // namespace toile
