#include "cloth/judge/certify.h"

#include <gtest/gtest.h>

#include "tests/cloth/panels.h"
#include "tests/support/shapes.h"

namespace toile {
namespace certify_test {

/// A sheet in two panels that are sewn in the plane x = 0; z = 0.3, before the block. Its points
/// at the seam are apart by rounding alone.
PanelMesh sheet() {
  PanelMesh garment;
  for (const double side : {-1.0, 1.0}) {
    test::add_panel(garment, side < 0 ? "right" : "left", test::grid(0.2, 0.2, 4, 4),
                    [&](const Vec2& p) {
                      const double x = side < 0 ? p.x() - 0.2 : p.x();
                      return Vec3(x + 1e-17 * side, 0.4 + p.y(), 0.3);
                    });
  }
  garment.seams = {test::seam("middle", test::side(garment.panels[0], 4, 4, true),
                              test::side(garment.panels[1], 4, 4, false))};
  return garment;
}

class Certified : public testing::Test {
 protected:
  const FrameCheck& check(const std::vector<Vec3>& points) {
    return certificate.check({garment, stage, points, 0.5});
  }
  std::vector<Vec3> moved(int panel, const Vec3& by) const {
    std::vector<Vec3> points = garment.placed;
    const MeshedPanel& which = garment.panels[panel];
    for (int p = which.first_point; p < which.first_point + which.points; ++p) points[p] += by;
    return points;
  }

  const PanelMesh garment = sheet();
  const TriangleMesh body = test::box({-0.5, 0, -0.1}, {0.5, 1, 0.1});
  const std::string stage = "close_seams";
  Certificate certificate{body, nullptr};
};

TEST_F(Certified, WhatIsSewnOrMeetsAtASeamIsClean) {
  const FrameCheck& found = check(garment.placed);
  EXPECT_TRUE(found.clean());
  EXPECT_EQ(found.open_pairs, 0);
  EXPECT_EQ(found.points, 50);
  EXPECT_EQ(found.stage, "close_seams");
}

TEST_F(Certified, EachKindOfIntersectionIsToldFromTheOthers) {
  // Half a triangle's width over its neighbour, slanted: it crosses at the seam and beyond it.
  std::vector<Vec3> across = moved(1, Vec3(-0.02, 0, 0));
  for (int p = 25; p < 50; ++p) across[p].z() += 0.1 * (across[p].x() + 0.01);
  FrameCheck found = check(across);
  EXPECT_EQ(found.open_pairs, 5);
  EXPECT_GT(found.self, 0);
  EXPECT_EQ(found.across_seams, found.self);
  EXPECT_EQ(found.body + found.layers + found.inside, 0);

  // Through its far end, where no seam will make them neighbours.
  std::vector<Vec3> far = moved(1, Vec3(-0.27, 0, 0));
  for (int p = 25; p < 50; ++p) far[p].z() += 0.5 * (far[p].x() + 0.17);
  found = check(far);
  EXPECT_GT(found.self, 0);
  EXPECT_EQ(found.across_seams, 0);

  // Stands half in the block, upright.
  std::vector<Vec3> through = garment.placed;
  for (Vec3& p : through) p.z() = p.y() - 0.45;
  found = check(through);
  EXPECT_GT(found.body, 0);
  EXPECT_EQ(found.self + found.inside, 0);

  // In the block as a whole, and half of it: nothing intersects.
  std::vector<Vec3> within = garment.placed;
  for (Vec3& p : within) p.z() = 0;
  found = check(within);
  EXPECT_EQ(found.inside, 1);
  EXPECT_EQ(found.body, 0);
  EXPECT_FALSE(found.clean());
  EXPECT_EQ(check(moved(1, Vec3(0, 0, -0.3))).inside, 1);
}

TEST_F(Certified, SaysSinceWhenItIsCleanAndWhetherItStayedSo) {
  EXPECT_FALSE(certificate.clean_from());
  EXPECT_FALSE(certificate.stayed_clean());
  const std::vector<Vec3> open = moved(1, Vec3(0.1, 0, 0));
  std::vector<Vec3> through = garment.placed;
  for (Vec3& p : through) p.z() = p.y() - 0.45;
  // Clean with open seams, then not: that is before its stay has begun.
  check(open);
  check(through);
  EXPECT_FALSE(certificate.clean_from());
  EXPECT_FALSE(certificate.stayed_clean());
  check(open);
  EXPECT_EQ(certificate.clean_from(), 2);
  EXPECT_FALSE(certificate.stayed_clean()) << "the seam never closed";
  check(garment.placed);
  EXPECT_EQ(certificate.clean_from(), 2);
  EXPECT_TRUE(certificate.stayed_clean());
  check(through);
  check(garment.placed);
  EXPECT_EQ(certificate.clean_from(), 5);
  EXPECT_FALSE(certificate.stayed_clean()) << "it was clean before, and sewn";
}

TEST_F(Certified, LayersBelowCount) {
  const TriangleMesh layer = test::box({-0.1, 0.45, 0.25}, {0.1, 0.55, 0.35});
  Certificate layered(body, &layer);
  const FrameCheck& found = layered.check({garment, stage, garment.placed, 0});
  EXPECT_GT(found.layers, 0);
  EXPECT_EQ(found.body + found.self, 0);
}

}  // namespace certify_test
}  // namespace toile
