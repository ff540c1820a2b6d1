#include "cloth/ease/girths.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/support/tubes.h"

namespace toile {
namespace girths_test {

/// A lathe-turned torso from y = 0.7 to 1.5. The hip at 0.9 stands out to the back, the waist is at
/// 1.1, and the bust at 1.3 stands out to the front.
TriangleMesh torso(int around) {
  struct Ring {
    double y, radius, forward;
  };
  const std::vector<Ring> rings = {{0.70, 0.12, 0}, {0.80, 0.14, 0},    {0.90, 0.16, -0.02},
                                   {1.10, 0.11, 0}, {1.30, 0.15, 0.03}, {1.42, 0.13, 0},
                                   {1.50, 0.05, 0}};
  TriangleMesh mesh;
  for (const Ring& ring : rings) {
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      mesh.points.emplace_back(ring.radius * std::sin(angle), ring.y,
                               ring.radius * std::cos(angle) + ring.forward);
    }
  }
  const int count = static_cast<int>(rings.size());
  for (int ring = 0; ring + 1 < count; ++ring) {
    for (int i = 0; i < around; ++i) {
      const int a = ring * around + i;
      const int b = ring * around + (i + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  for (const int ring : {0, count - 1}) {
    const int middle = static_cast<int>(mesh.points.size());
    mesh.points.emplace_back(0, rings[static_cast<std::size_t>(ring)].y, 0);
    for (int i = 0; i < around; ++i) {
      const int a = ring * around + i;
      const int b = ring * around + (i + 1) % around;
      if (ring == 0) {
        mesh.triangles.push_back({b, a, middle});
      } else {
        mesh.triangles.push_back({a, b, middle});
      }
    }
  }
  return mesh;
}

Skeleton joints() {
  Skeleton skeleton;
  skeleton.joints = {{"pelvis", {0, 0.75, 0}}, {"waist", {0, 1.08, 0}}, {"chest", {0, 1.40, 0}}};
  return skeleton;
}

const Girth* level(const Girths& girths, const std::string& name) {
  for (const Girth& girth : girths.rows) {
    if (girth.name == name) return &girth;
  }
  return nullptr;
}

TEST(Girths, NamedLevelsAreFoundOnTheBody) {
  const auto girths =
      measure_girths(test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15), torso(200), joints(), {});
  const double circle = 2 * std::numbers::pi;
  const std::vector<std::pair<std::string, Vec2>> expected = {
      {"bust", {1.30, 0.15}}, {"waist", {1.10, 0.11}}, {"hip", {0.90, 0.16}}};
  for (const auto& [name, place] : expected) {
    const Girth* found = level(girths, name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_NEAR(found->height, place.x(), 0.006) << name;
    EXPECT_NEAR(found->body, circle * place.y(), 0.008) << name;
    EXPECT_NEAR(found->garment, circle * 0.25, 0.001) << name;
    EXPECT_NEAR(found->ease(), found->garment - found->body, 1e-12) << name;
    EXPECT_NEAR(found->garment, found->hull, 1e-9) << name;
  }
}

TEST(Girths, AsCutIsOnTheFlatPanels) {
  // On the flat each panel is 100 cells of 1 cm wide and 15 high; the rows lie anywhere in space.
  DressedGarment garment = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  for (const Girth& girth : measure_girths(garment, torso(60), joints(), {}).rows) {
    EXPECT_NEAR(girth.as_cut, 2, 1e-9);
    EXPECT_NEAR(girth.garment, 2 * std::numbers::pi * 0.25, 1e-3);
  }
  // Hung askew by 10 cm in 50, the line runs askew over the flat panels, as wide as before.
  for (Vec3& p : garment.points) p.y() += 0.2 * p.x();
  for (const Girth& girth : measure_girths(garment, torso(60), joints(), {}).rows) {
    EXPECT_NEAR(girth.as_cut, 2, 1e-9);
    ASSERT_EQ(girth.panels.size(), 2U);
    EXPECT_NEAR(girth.panels[0].width, 1, 1e-9);
    // 15 rows of 1 cm hang over 75 cm. On average the line lies where its height is.
    EXPECT_NEAR(girth.panels[0].flat_height, 0.15 * (girth.height - 0.7) / 0.75, 0.002);
  }
}

TEST(Girths, APanelCutAcrossTheGrainIsMeasuredAlongIt) {
  DressedGarment garment = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  for (Vec2& p : garment.flat) p = Vec2(-p.y(), p.x());
  for (const std::vector<double>& grains :
       {std::vector<double>{}, std::vector<double>{std::numbers::pi / 2, std::numbers::pi / 2}}) {
    for (const Girth& girth :
         measure_girths(garment, torso(60), joints(), {}, {.grains = grains}).rows) {
      EXPECT_NEAR(girth.as_cut, 2, 1e-9);
    }
  }
}

TEST(Girths, APieceDrawnAskewIsMeasuredSquareToItsGrain) {
  const double angle = 0.4;
  DressedGarment garment = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  for (Vec2& p : garment.flat) p = Eigen::Rotation2Dd(angle) * p;
  for (const Girth& girth :
       measure_girths(garment, torso(60), joints(), {}, {.grains = {angle, angle}}).rows) {
    EXPECT_NEAR(girth.as_cut, 2, 1e-9);
  }
}

TEST(Girths, ALevelThatIsLeftOutSaysWhy) {
  const Girths girths =
      measure_girths(test::cloth_tube(0.25, 0.25, 0.7, 1.2, 40, 15), torso(60), joints(), {});
  EXPECT_EQ(level(girths, "bust"), nullptr);
  EXPECT_NE(level(girths, "waist"), nullptr);
  ASSERT_EQ(girths.left_out.size(), 1U);
  EXPECT_EQ(girths.left_out[0].name, "bust");
  EXPECT_EQ(girths.left_out[0].why, "the garment does not reach it");
  EXPECT_FALSE(girths.left_out[0].is_open);
}

TEST(Girths, WhereTheLineRunsAroundAnArmItIsTakenBelow) {
  Skeleton skeleton = joints();
  skeleton.joints["left_shoulder"] = {0.2, 1.4, 0};
  skeleton.joints["left_elbow"] = {0.24, 1.28, 0};
  skeleton.joints["left_wrist"] = {0.5, 1.0, 0};
  skeleton.segments = {{"left_arm", "left_shoulder", "left_elbow"},
                       {"left_arm", "left_elbow", "left_wrist"}};
  const TriangleMesh body = torso(200);
  const DressedGarment tube = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  const Girths girths = measure_girths(tube, body, skeleton, {});
  const Girth* bust = level(girths, "bust");
  ASSERT_NE(bust, nullptr);
  // The arm comes out of the tube 1.1 cm below the elbow. The bust is at 1.30.
  EXPECT_NEAR(bust->height, 1.265, 0.005);
  EXPECT_NEAR(bust->body, level(measure_girths(tube, body, joints(), {}), "bust")->body, 1e-9);
  // An arm that hangs straight down stays within.
  skeleton.joints["left_wrist"] = {0.24, 0.9, 0};
  const Girths under_a_cape = measure_girths(tube, body, skeleton, {});
  EXPECT_EQ(level(under_a_cape, "bust"), nullptr);
  ASSERT_FALSE(under_a_cape.left_out.empty());
  EXPECT_EQ(under_a_cape.left_out[0].name, "bust");
  EXPECT_EQ(under_a_cape.left_out[0].why, "its line there runs around the arms");
}

TEST(Girths, FromTheTopDown) {
  const auto girths =
      measure_girths(test::cloth_tube(0.25, 0.25, 0.7, 1.45, 40, 15), torso(60), joints(), {});
  ASSERT_GT(girths.rows.size(), 10U);
  for (std::size_t i = 1; i < girths.rows.size(); ++i) {
    EXPECT_LE(girths.rows[i].height, girths.rows[i - 1].height);
  }
}

TEST(Girths, AnOpenGarmentHasNone) {
  DressedGarment front = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 40, 15);
  front.triangles.resize(front.triangles.size() / 2);
  EXPECT_TRUE(measure_girths(front, torso(60), joints(), {}).rows.empty());
}

TEST(Girths, ATubeBesideTheTorsoIsNotAroundIt) {
  DressedGarment sleeve = test::cloth_tube(0.05, 0.05, 0.7, 1.45, 40, 15);
  for (Vec3& point : sleeve.points) point.x() += 0.4;
  EXPECT_TRUE(measure_girths(sleeve, torso(60), joints(), {}).rows.empty());
}

TEST(Girths, WhatTouchesIsMeasuredAtItsInnerFace) {
  const TriangleMesh body = torso(200);
  const SurfaceDistance skin(body);
  // The waist of 11 cm has cloth all around, 2 mm off the skin; at bust and hip it is inside.
  const DressedGarment tube = test::cloth_tube(0.112, 0.112, 1.05, 1.15, 200, 10);
  const Girths girths =
      measure_girths(tube, body, joints(), {}, {.step = 0, .skin = &skin, .touching = 0.003});
  const Girth* waist = level(girths, "waist");
  ASSERT_NE(waist, nullptr);
  EXPECT_GT(waist->garment - waist->body, 0.01);
  EXPECT_NEAR(waist->ease(), 0, 1e-4);
}

TEST(Girths, AFoldThatLiesLevelIsNoGirth) {
  // Every other point of a ring stands out by 6 cm: the section is a star.
  DressedGarment tube = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 40, 15);
  for (std::size_t i = 0; i < tube.points.size(); i += 2) {
    tube.points[i].x() *= 1.3;
    tube.points[i].z() *= 1.3;
  }
  const Girth* hip = nullptr;
  const Girths girths = measure_girths(tube, torso(60), joints(), {});
  hip = level(girths, "hip");
  ASSERT_NE(hip, nullptr);
  EXPECT_GT(hip->garment, fold_share * hip->hull);
  EXPECT_FALSE(hip->is_girth());
}

TEST(Girths, OfASeamAcrossTheLevelOneSideCounts) {
  // The upper half of the front is a panel of its own, and hangs askew: the level runs through
  // both.
  DressedGarment garment = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  garment.panels.emplace_back("yoke");
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const double height = garment.flat[garment.flat_triangles[t][0]].y();
    if (garment.panel_of_triangle[t] == 0 && height > 0.075) garment.panel_of_triangle[t] = 2;
  }
  for (Vec3& p : garment.points) p.y() += 0.2 * p.x();
  const Girths girths = measure_girths(garment, torso(60), joints(), {});
  int parted = 0;
  for (const Girth& girth : girths.rows) {
    if (girth.panels.size() == 3) ++parted;
    EXPECT_NEAR(girth.as_cut, 2, 0.02) << girth.height;
  }
  EXPECT_GT(parted, 0);
}

}  // namespace girths_test
}  // namespace toile
