#include "cloth/contact/body_bounds.h"

#include <gtest/gtest.h>

#include <random>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/scene/collider.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"

namespace toile {
namespace body_bounds_test {

/// A box with a spike on it: a pyramid 1 cm wide and 6 cm high.
TriangleMesh spiked_box() {
  return test::together(test::box({-0.2, -0.05, -0.2}, {0.2, 0, 0.2}),
                        test::spike(0, 0, 0.005, 0.06));
}

/// Corners move at random, as far as the bounds allow, again and again. They never pass a facet.
TEST(BodyBounds, NothingThatKeepsToThemMeetsTheBody) {
  const Collider body{spiked_box()};
  PanelMesh garment;
  test::add_panel(garment, "sheet", test::grid(0.2, 0.2, 10, 10), [](const Vec2& p) {
    return Vec3(p.x() - 0.1 + 0.003, 0.065, p.y() - 0.1 + 0.002);
  });
  std::vector<Vec3> x = garment.placed;
  BodyBounds bounds(body, garment.triangles, x.size());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  int stopped = 0;
  for (int round = 0; round < 200; ++round) {
    bounds.update(as_vec4(x));
    for (std::size_t v = 0; v < x.size(); ++v) {
      // 3 cm down a round, and up to 1 cm sideways.
      const Vec3 wanted = x[v] + Vec3(0.01 * any(random), -0.03, 0.01 * any(random));
      const double free = bounds.free_radius(static_cast<int>(v), x[v]);
      const double share = bounds.allowed_share(static_cast<int>(v), x[v], wanted);
      EXPECT_GE(share * (wanted - x[v]).norm(),
                std::min(free, (wanted - x[v]).norm()) * 0.99 - 1e-12);
      stopped += share < 1;
      x[v] += share * (wanted - x[v]);
    }
    ASSERT_TRUE(intersections({x, garment.triangles}, body.body()).empty()) << round;
  }
  EXPECT_GT(stopped, 1000);
}

/// A triangle that intersects the body is free to come out. Once it is out, it is bound.
TEST(BodyBounds, WhatMeetsTheBodyCanComeOut) {
  const Collider body{test::box({-0.2, -0.05, -0.2}, {0.2, 0, 0.2})};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  std::vector<Vec3> x = {{0, -0.01, 0}, {0.02, 0.01, 0}, {0, 0.01, 0.02}};
  BodyBounds bounds(body, triangles, 3);
  bounds.update(as_vec4(x));
  EXPECT_GT(bounds.free_radius(0, x[0]), 1);
  EXPECT_EQ(bounds.allowed_share(0, x[0], {0, 0.01, 0}), 1);
  x[0] = {0, 0.01, 0};
  bounds.recheck_intersecting();
  for (int i = 0; i < 4; ++i) bounds.update(as_vec4(x));  // a region is updated every few calls
  EXPECT_LT(bounds.free_radius(0, x[0]), 0.01);
  for (int i = 0; i < 80; ++i) {
    x[0] += bounds.allowed_share(0, x[0], {0, -0.01, 0}) * (Vec3(0, -0.01, 0) - x[0]);
    bounds.update(as_vec4(x));
  }
  EXPECT_GT(x[0].y(), 0);
  EXPECT_LT(x[0].y(), 1e-4);  // the plane just above the flat top of the box
}

/// A triangle wholly inside meets no facet, but must be free to come out. A triangle just outside
/// must not go in. This holds near the skin, where a region has a plane, and far from it.
TEST(BodyBounds, WhatIsInsideCanComeOut) {
  const Collider body{test::box({-0.2, -0.2, -0.2}, {0.2, 0, 0.2})};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  for (const double depth : {0.00005, 0.0002, 0.001, 0.004, 0.03, 0.1}) {
    for (const double side : {-1, 1}) {
      const double y = side * depth;
      std::vector<Vec3> x = {{0, y, 0}, {0.02, y, 0}, {0, y, 0.02}};
      BodyBounds bounds(body, triangles, 3);
      bounds.update(as_vec4(x));
      const Vec3 through(0, -2 * y, 0);
      const double share = bounds.allowed_share(0, x[0], x[0] + through);
      if (side < 0) {
        EXPECT_EQ(share, 1) << y;
      } else {
        EXPECT_LE(share, 0.5) << y;
      }
    }
  }
}

/// A triangle lies 4 mm beside a step, and slightly higher than it. No plane at the step's height
/// stops the triangle, and nothing lifts it.
TEST(BodyBounds, WhatIsClearBesideAStepIsNotHeldAtItsHeight) {
  const Collider body{test::together(test::box({-0.2, -0.2, -0.2}, {0.2, 0, 0.2}),
                                     test::box({0.024, 0.00005, -0.2}, {0.2, 0.0099, 0.2}))};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const std::vector<Vec3> x = {{0, 0.01, 0}, {0.02, 0.01, 0}, {0, 0.01, 0.02}};
  BodyBounds bounds(body, triangles, 3);
  for (int i = 0; i < 40; ++i) {
    bounds.update(as_vec4(x));
    for (int v = 0; v < 3; ++v) {
      // A region that stops a corner becomes due.
      EXPECT_EQ(bounds.allowed_share(v, x[v], x[v] - Vec3(0, 0.003, 0)), 1);
      EXPECT_LT(bounds.allowed_share(v, x[v], x[v] + Vec3(0.02, -0.009, 0)), 0.5);
    }
  }
  for (int v = 0; v < 3; ++v) {
    EXPECT_GT(bounds.free_radius(v, x[v]), 0.003);
    EXPECT_EQ(bounds.extra_offset(v), 0);
  }
}

/// A sheet falls on a spike that is finer than the mesh of the sheet. It comes to hang on the
/// spike, and no facet passes through it at any time.
TEST(BodyBounds, ASheetHangsOnASpike) {
  const Collider body{spiked_box()};
  PanelMesh garment;
  test::add_panel(garment, "sheet", test::grid(0.3, 0.3, 12, 12), [](const Vec2& p) {
    return Vec3(p.x() - 0.15 + 0.003, 0.08, p.y() - 0.15 + 0.002);
  });
  Scene scene;
  scene.collider = &body;
  const GarmentModel model = compile(garment, scene, garment.placed);
  RelaxOptions options;
  options.bounded = true;
  options.max_iterations = 3000;
  std::vector<Vec3> x = model.start;
  int unclean = 0;
  relax(model, options, x, [&](const RelaxProgress& at) {
    unclean += !intersections({at.nodes, model.node_triangles}, body.body()).empty();
  });
  EXPECT_EQ(unclean, 0);
  double lowest = 1;
  double highest = -1;
  for (const Vec3& p : x) {
    lowest = std::min(lowest, p.y());
    highest = std::max(highest, p.y());
  }
  EXPECT_GT(highest, 0.06);
  EXPECT_LT(lowest, 0.02);
  // Without bounds, the spike passes through the sheet.
  scene.body_contact = BodyContactTerm::nodes;
  const GarmentModel unbounded = compile(garment, scene, garment.placed);
  std::vector<Vec3> free = model.start;
  relax(unbounded, options, free);
  EXPECT_FALSE(intersections({free, model.node_triangles}, body.body()).empty());
}

}  // namespace body_bounds_test
}  // namespace toile
