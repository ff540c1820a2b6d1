#include "cloth/ease/girth_ease.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/support/tubes.h"

namespace toile {
namespace girth_ease_test {

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

const GirthEase* level(const GirthEases& girths, const std::string& name) {
  for (const GirthEase& girth : girths.levels) {
    if (girth.level == name) return &girth;
  }
  return nullptr;
}

TEST(GirthEase, NamedLevelsAreFoundOnTheBody) {
  const auto girths =
      measure_girth_ease(test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15), torso(200), joints());
  const double circle = 2 * std::numbers::pi;
  const std::vector<std::pair<std::string, Vec2>> expected = {
      {"bust", {1.30, 0.15}}, {"waist", {1.10, 0.11}}, {"hip", {0.90, 0.16}}};
  for (const auto& [name, place] : expected) {
    const GirthEase* found = level(girths, name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_NEAR(found->height, place.x(), 0.006) << name;
    EXPECT_NEAR(found->body, circle * place.y(), 0.008) << name;
    EXPECT_NEAR(found->garment, circle * 0.25, 0.001) << name;
    EXPECT_NEAR(found->ease, found->garment - found->body, 1e-12) << name;
  }
}

TEST(GirthEase, AsCutIsOnTheFlatPanels) {
  // On the flat each panel is 100 cells of 1 cm wide and 15 high; the rows lie anywhere in space.
  DressedGarment garment = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  for (const GirthEase& girth : measure_girth_ease(garment, torso(60), joints()).levels) {
    EXPECT_NEAR(girth.as_cut, 2, 1e-9);
    EXPECT_NEAR(girth.garment, 2 * std::numbers::pi * 0.25, 1e-3);
  }
  // Hung askew by 10 cm in 50, the line runs askew over the flat panels, as wide as before.
  for (Vec3& p : garment.points) p.y() += 0.2 * p.x();
  for (const GirthEase& girth : measure_girth_ease(garment, torso(60), joints()).levels) {
    EXPECT_NEAR(girth.as_cut, 2, 1e-9);
    ASSERT_EQ(girth.panels.size(), 2U);
    EXPECT_NEAR(girth.panels[0].width, 1, 1e-9);
    // 15 rows of 1 cm hang over 75 cm. On average the line lies where its height is.
    EXPECT_NEAR(girth.panels[0].flat_height, 0.15 * (girth.height - 0.7) / 0.75, 0.002);
  }
}

TEST(GirthEase, APanelCutAcrossTheGrainIsMeasuredAlongIt) {
  DressedGarment garment = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  for (Vec2& p : garment.flat) p = Vec2(-p.y(), p.x());
  for (const std::vector<double>& grains :
       {std::vector<double>{}, std::vector<double>{std::numbers::pi / 2, std::numbers::pi / 2}}) {
    for (const GirthEase& girth : measure_girth_ease(garment, torso(60), joints(), grains).levels) {
      EXPECT_NEAR(girth.as_cut, 2, 1e-9);
    }
  }
}

TEST(GirthEase, APieceDrawnAskewIsMeasuredSquareToItsGrain) {
  const double angle = 0.4;
  DressedGarment garment = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 200, 15);
  for (Vec2& p : garment.flat) p = Eigen::Rotation2Dd(angle) * p;
  for (const GirthEase& girth :
       measure_girth_ease(garment, torso(60), joints(), {angle, angle}).levels) {
    EXPECT_NEAR(girth.as_cut, 2, 1e-9);
  }
}

TEST(GirthEase, ALevelThatIsLeftOutSaysWhy) {
  const GirthEases girths =
      measure_girth_ease(test::cloth_tube(0.25, 0.25, 0.7, 1.2, 40, 15), torso(60), joints());
  EXPECT_EQ(level(girths, "bust"), nullptr);
  EXPECT_NE(level(girths, "waist"), nullptr);
  ASSERT_EQ(girths.left_out.size(), 1U);
  EXPECT_EQ(girths.left_out[0].level, "bust");
  EXPECT_EQ(girths.left_out[0].why, "the garment does not reach it");
  EXPECT_FALSE(girths.left_out[0].is_open);
}

TEST(GirthEase, FromTheTopDown) {
  const auto girths =
      measure_girth_ease(test::cloth_tube(0.25, 0.25, 0.7, 1.45, 40, 15), torso(60), joints());
  ASSERT_GT(girths.levels.size(), 10U);
  for (std::size_t i = 1; i < girths.levels.size(); ++i) {
    EXPECT_LE(girths.levels[i].height, girths.levels[i - 1].height);
  }
}

TEST(GirthEase, AnOpenGarmentHasNone) {
  DressedGarment front = test::cloth_tube(0.25, 0.25, 0.7, 1.45, 40, 15);
  front.triangles.resize(front.triangles.size() / 2);
  EXPECT_TRUE(measure_girth_ease(front, torso(60), joints()).levels.empty());
}

TEST(GirthEase, ATubeBesideTheTorsoIsNotAroundIt) {
  DressedGarment sleeve = test::cloth_tube(0.05, 0.05, 0.7, 1.45, 40, 15);
  for (Vec3& point : sleeve.points) point.x() += 0.4;
  EXPECT_TRUE(measure_girth_ease(sleeve, torso(60), joints()).levels.empty());
}

}  // namespace girth_ease_test
}  // namespace toile
