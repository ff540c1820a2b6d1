#include "cloth/start/move_off_layers.h"

#include <gtest/gtest.h>

#include "tests/cloth/figure.h"
#include "tests/support/shapes.h"

namespace toile {
namespace move_off_layers_test {

const SurfaceDistance& block() {
  static const SurfaceDistance body(test::box({-0.15, 0, -0.1}, {0.15, 1, 0.1}));
  return body;
}

/// A panel before the block and one behind, both facing away from it, at `front` and `back`.
PanelMesh sandwich(double front, double back) {
  PanelMesh garment;
  test::add_panel(garment, "front", test::grid(0.2, 0.3, 8, 12),
                  [&](const Vec2& p) { return Vec3(p.x() - 0.1, 0.4 + p.y(), front); });
  test::add_panel(garment, "back", test::grid(0.2, 0.3, 8, 12),
                  [&](const Vec2& p) { return Vec3(0.1 - p.x(), 0.4 + p.y(), back); });
  return garment;
}

TEST(StepOut, PanelsStepBackUntilTheyAreClear) {
  const DistanceGrid collider{block()};
  const PanelMesh garment = sandwich(0.065, -0.3);
  Placement placement;
  placement.placed = garment.placed;
  placement.points_inside = 77;
  move_off_layers(garment, collider, placement);
  // 35 mm deep, and 10 mm clear.
  EXPECT_EQ(placement.moved_off_layers.size(), 1U);
  EXPECT_NEAR(placement.moved_off_layers.at("front"), 0.05, 1e-12);
  EXPECT_EQ(placement.points_inside, 0);
  for (std::size_t p = 0; p < garment.placed.size(); ++p) {
    const double out = garment.placed[p].z() > 0 ? 0.05 : 0;
    EXPECT_LT((placement.placed[p] - garment.placed[p] - Vec3(0, 0, out)).norm(), 1e-12);
  }
}

TEST(StepOut, WhatNoStepClearsAndWhatIsRolledStays) {
  const DistanceGrid collider{block()};
  // Faces into the block, whose far side is beyond the longest step.
  PanelMesh garment;
  test::add_panel(garment, "inward", test::grid(0.05, 0.05, 4, 4),
                  [](const Vec2& p) { return Vec3(p.x(), 0.06, 0.05 - p.y()); });
  for (Triangle& t : garment.triangles) std::swap(t[1], t[2]);
  const double girth = 2 * test::pi * 0.05;
  test::add_panel(garment, "rolled", test::grid(girth, 0.3, 24, 6), [](const Vec2& p) {
    const double angle = p.x() / 0.05;
    return Vec3(0.05 * std::sin(angle), 0.4 + p.y(), 0.05 * std::cos(angle));
  });
  Placement placement;
  placement.placed = garment.placed;
  move_off_layers(garment, collider, placement);
  EXPECT_EQ(placement.moved_off_layers.count("rolled"), 0U);
  EXPECT_EQ(placement.points_inside > 0, true);
  const MeshedPanel& rolled = garment.panels[1];
  for (int p = rolled.first_point; p < rolled.first_point + rolled.points; ++p) {
    EXPECT_EQ(placement.placed[p], garment.placed[p]);
  }
}

}  // namespace move_off_layers_test
}  // namespace toile
