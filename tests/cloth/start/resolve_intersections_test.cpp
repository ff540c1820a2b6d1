#include "cloth/start/resolve_intersections.h"

#include <gtest/gtest.h>

#include "geometry/intersections.h"
#include "tests/cloth/figure.h"
#include "tests/pattern/samples.h"
#include "tests/support/shapes.h"

namespace toile {
namespace resolve_intersections_test {

const TriangleMesh& block() {
  static const TriangleMesh body = test::box({-0.15, 0, -0.1}, {0.15, 1, 0.1});
  return body;
}
const DistanceGrid& distance() {
  static const DistanceGrid grid{SurfaceDistance(block())};
  return grid;
}

/// Adds an upright panel 20 cm wide and 30 cm high whose right side faces +z, or -z.
void add_upright(PanelMesh& garment, const std::string& name, const Vec3& at, double facing = 1) {
  test::add_panel(garment, name, test::grid(0.2, 0.3, 8, 12), [&](const Vec2& p) {
    return Vec3(at + Vec3(facing * (p.x() - 0.1), 0.4 + p.y(), 0));
  });
}

Placement cleared(const PanelMesh& garment, const Skeleton* skeleton = nullptr) {
  Placement placement;
  placement.placed = garment.placed;
  placement.points_inside = 77;
  resolve_intersections(garment, block(), distance(), skeleton, placement);
  return placement;
}

void expect_clear(const PanelMesh& garment, const Placement& placement) {
  EXPECT_TRUE(crossing_panels(garment, placement.placed).empty());
  EXPECT_TRUE(intersections({placement.placed, garment.triangles}, block()).empty());
  for (const Vec3& p : placement.placed) EXPECT_GT(distance().at(p).distance, 0);
}

/// How far a panel was moved; all its points the same way.
Vec3 move_of(const PanelMesh& garment, const Placement& placement, int panel) {
  const MeshedPanel& which = garment.panels[panel];
  const Vec3 move = placement.placed[which.first_point] - garment.placed[which.first_point];
  for (int p = which.first_point; p < which.first_point + which.points; ++p) {
    EXPECT_LT((placement.placed[p] - garment.placed[p] - move).norm(), 1e-12);
  }
  return move;
}

TEST(ClearStart, WhatStandsClearStaysBitForBit) {
  PanelMesh garment;
  add_upright(garment, "front", {0, 0, 0.12});
  add_upright(garment, "back", {0, 0, -0.12}, -1);
  // Beside the front and sewn to it where both stand, apart by rounding alone.
  add_upright(garment, "side", {0.2 + 1e-17, 0, 0.12});
  garment.seams = {test::seam("joined", test::side(garment.panels[0], 8, 12, true),
                              test::side(garment.panels[2], 8, 12, false))};
  const Placement placement = cleared(garment);
  EXPECT_TRUE(placement.moved_clear.empty());
  EXPECT_EQ(placement.placed, garment.placed);
}

TEST(ClearStart, PanelsThroughEachOtherMoveApart) {
  PanelMesh garment;
  add_upright(garment, "front", {0, 0, 0.2});
  // Slanted through it, and in front of both one that the second would be moved into.
  test::add_panel(garment, "slanted", test::grid(0.2, 0.3, 8, 12), [](const Vec2& p) {
    return Vec3(p.x() - 0.1, 0.4 + p.y(), 0.2 + 0.2 * (p.x() - 0.05));
  });
  add_upright(garment, "farther", {0, 0, 0.26});
  ASSERT_FALSE(crossing_panels(garment, garment.placed).empty());
  const Placement placement = cleared(garment);
  expect_clear(garment, placement);
  // The nearest to the body stays: from there the others go on.
  EXPECT_EQ(move_of(garment, placement, 0), Vec3::Zero());
  EXPECT_GT(move_of(garment, placement, 1).z(), 0.01);
  EXPECT_LT(move_of(garment, placement, 1).z(), 0.04);
  EXPECT_EQ(placement.moved_clear.count("front"), 0U);
  EXPECT_NEAR(placement.moved_clear.at("slanted"), move_of(garment, placement, 1).norm(), 1e-12);
  EXPECT_EQ(placement.points_inside, 0);
}

TEST(ClearStart, PanelsInTheBodyComeOutTheWayTheyFace) {
  PanelMesh garment;
  add_upright(garment, "front", {0, 0, 0.02});
  add_upright(garment, "back", {0, 0, -0.02}, -1);
  const Placement placement = cleared(garment);
  expect_clear(garment, placement);
  for (int panel = 0; panel < 2; ++panel) {
    const Vec3 move = (panel == 0 ? 1 : -1) * move_of(garment, placement, panel);
    EXPECT_GE(move.z(), 0.08) << panel;
    EXPECT_LE(move.z(), 0.105) << panel;
  }
}

TEST(ClearStart, PanelsOnTheWrongSideAreNotSentThroughTheBody) {
  PanelMesh garment;
  // A back before the body, where the front stands.
  add_upright(garment, "front", {0, 0, 0.15});
  add_upright(garment, "back", {0, 0, 0.15}, -1);
  const Placement placement = cleared(garment);
  expect_clear(garment, placement);
  EXPECT_EQ(move_of(garment, placement, 0), Vec3::Zero());
  EXPECT_NEAR(move_of(garment, placement, 1).z(), 0.02, 1e-12);
}

TEST(ClearStart, HalvesThatStandJoinedMoveAsOne) {
  PanelMesh garment;
  for (const double side : {-1.0, 1.0}) {
    test::add_panel(garment, side < 0 ? "right" : "left", test::grid(0.1, 0.3, 4, 12),
                    [&](const Vec2& p) {
                      const double x = side < 0 ? p.x() - 0.1 : p.x();
                      return Vec3(x, 0.4 + p.y(), 0.05 - std::abs(x));
                    });
  }
  garment.seams = {test::seam("middle", test::side(garment.panels[0], 4, 12, true),
                              test::side(garment.panels[1], 4, 12, false))};
  const Placement placement = cleared(garment);
  expect_clear(garment, placement);
  EXPECT_EQ(placement.moved_clear.size(), 2U);
  EXPECT_LT((move_of(garment, placement, 0) - move_of(garment, placement, 1)).norm(), 1e-12);
}

TEST(ClearStart, ARolledPanelIsWidened) {
  PanelMesh garment;
  const double radius = 0.14;
  MeshedPanel& tube = test::add_panel(
      garment, "tube", test::grid(1.9 * test::pi * radius, 0.3, 48, 12), [&](const Vec2& p) {
        const double angle = p.x() / radius;
        return Vec3(radius * std::sin(angle), 0.4 + p.y(), radius * std::cos(angle));
      });
  tube.is = classify({"", BodyPart::torso});
  tube.placement.around = 1;
  const Skeleton figure = test::figure();
  const Placement placement = cleared(garment, &figure);
  expect_clear(garment, placement);
  // The block's corners are 18 cm from its middle.
  EXPECT_GE(placement.moved_clear.at("tube"), 0.04);
  EXPECT_LE(placement.moved_clear.at("tube"), 0.08);
}

TEST(ClearStart, WhatFindsNoPlaceIsNamed) {
  PanelMesh garment;
  add_upright(garment, "good", {0, 0, 0.2});
  // Lies through the block, and along it there is no way out.
  test::add_panel(garment, "shelf", test::grid(0.5, 0.5, 10, 10),
                  [](const Vec2& p) { return Vec3(p.x() - 0.25, 0.05, 0.25 - p.y()); });
  const TriangleMesh tower = test::box({-0.15, -2, -0.1}, {0.15, 3, 0.1});
  const DistanceGrid grid{SurfaceDistance(tower)};
  Placement placement;
  placement.placed = garment.placed;
  const std::string message =
      samples::error_of([&] { resolve_intersections(garment, tower, grid, nullptr, placement); });
  EXPECT_HOLDS(message, "'shelf'");
  EXPECT_HOLDS(message, "find no place");
  EXPECT_EQ(message.find("good"), std::string::npos) << message;
}

}  // namespace resolve_intersections_test
}  // namespace toile
