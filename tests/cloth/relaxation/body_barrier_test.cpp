#include "cloth/relaxation/body_barrier.h"

#include <gtest/gtest.h>

#include "cloth/scene/collider.h"
#include "tests/support/shapes.h"

namespace toile {
namespace body_barrier_test {

Vec4s points(const std::vector<Vec3>& at) { return as_vec4(at); }

class BodyBarrierTest : public testing::Test {
 protected:
  BodyBarrierTest() : body_{test::sphere(0.1, 4)} { scene_.collider = &body_; }

  Vec3 place(const BodyBarrier::Correction& found, const Vec4s& x) const {
    Vec3 at = Vec3::Zero();
    for (int i = 0; i < 3; ++i) at += found.place.weights[i] * as_vec3(x[found.place.points[i]]);
    return at;
  }

  Collider body_;
  Scene scene_;
};

TEST_F(BodyBarrierTest, ClothBesideTheBodyStays) {
  const Vec4s x = points({{0.2, 0, 0}, {0.3, 0, 0}, {0.2, 0.1, 0}});
  BodyBarrier barrier(scene_, {{0, 1, 2}}, {}, x);
  EXPECT_TRUE(barrier.find(x).empty());
}

TEST_F(BodyBarrierTest, PointsAndEdgesInTheBodyLeaveIt) {
  // The edge from 0 to 1 passes through the sphere, 2 cm below its top; no point is inside.
  const Vec4s x = points({{-0.2, 0.08, 0}, {0.2, 0.08, 0}, {0, 0.3, 0}});
  BodyBarrier barrier(scene_, {{0, 1, 2}}, {}, x);
  const auto& found = barrier.find(x);
  ASSERT_FALSE(found.empty());
  for (const auto& correction : found) {
    EXPECT_TRUE(correction.place.weights[2] == 0 || correction.place.points[2] == 2);
    const Vec3 out = place(correction, x) + correction.out;
    EXPECT_NEAR(out.norm(), 0.101, 0.001) << out.transpose();
  }
}

TEST_F(BodyBarrierTest, WhatComesThroughTheMiddleOfATriangleIsHeldOff) {
  // A triangle of 40 cm, 2 cm below the sphere's top: its points and edges are all outside.
  const Vec4s x = points({{0, 0.08, 0.25}, {0.22, 0.08, -0.13}, {-0.22, 0.08, -0.13}});
  BodyBarrier barrier(scene_, {{0, 1, 2}}, {}, x);
  const auto& found = barrier.find(x);
  ASSERT_FALSE(found.empty());
  for (const auto& correction : found) {
    const Vec3 out = place(correction, x) + correction.out;
    EXPECT_NEAR(out.norm(), 0.101, 0.001) << out.transpose();
    EXPECT_GT(correction.place.weights[2], 0);
  }
}

TEST_F(BodyBarrierTest, TheGapOfAnOpenSeamIsHeldOffToo) {
  // Two triangles before and behind the sphere, with a seam over its middle.
  const Vec4s x = points({{0, 0.05, 0.2},
                          {0.1, 0.2, 0.2},
                          {-0.1, 0.2, 0.2},
                          {0, 0.05, -0.2},
                          {0.1, 0.2, -0.2},
                          {-0.1, 0.2, -0.2}});
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 5, 4}};
  BodyBarrier without(scene_, triangles, {}, x);
  EXPECT_TRUE(without.find(x).empty());
  BodyBarrier barrier(scene_, triangles, {{0, 3}}, x);
  const auto& found = barrier.find(x);
  ASSERT_FALSE(found.empty());
  for (const auto& correction : found) EXPECT_GT(correction.out.y(), 0);
}

TEST_F(BodyBarrierTest, AProbeThatMovesIsLookedAtAgain) {
  Vec4s x = points({{0, 0.5, 0}, {0.01, 0.5, 0}, {0, 0.51, 0}});
  BodyBarrier barrier(scene_, {{0, 1, 2}}, {}, x);
  EXPECT_TRUE(barrier.find(x).empty());
  int steps = 0;
  for (; steps < 200 && barrier.find(x).empty(); ++steps) {
    for (Vec4& p : x) p[1] -= 0.004;
  }
  // As soon as it comes within a millimetre of the skin.
  EXPECT_NEAR(x[0][1], 0.1, 0.006);
}

}  // namespace body_barrier_test
}  // namespace toile
