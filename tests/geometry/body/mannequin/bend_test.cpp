#include "geometry/body/mannequin/bend.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace toile {
namespace bend_test {

constexpr double degree = std::numbers::pi / 180;

Bend knee(double degrees) {
  return {Vec3(0.1, 0.5, 0), -Vec3::UnitY(), -Vec3::UnitZ(), degrees * degree, 0.07};
}

TEST(Bend, BackAndForthIsTheSamePoint) {
  double worst = 0;
  for (const double angle : {0.0, 0.001, 5.0, 20.0, 60.0, 80.0}) {
    const Bend bend = knee(angle);
    for (double y = 0.1; y < 0.9; y += 0.013) {
      for (double z = -0.06; z < 0.2; z += 0.02) {
        const Vec3 rest(0.13, y, z);
        worst = std::max(worst, (bend.rest(bend.posed(rest)) - rest).norm());
      }
    }
  }
  RecordProperty("worst_metres", std::to_string(worst));
  EXPECT_LT(worst, 1e-9);
}

TEST(Bend, BonesMoveRigidlyAndMeetInTheJoint) {
  const Bend bend = knee(60);
  const Vec3 joint(0.1, 0.5, 0);
  EXPECT_EQ(bend.posed(Vec3(0.1, 0.7, 0.03)), Vec3(0.1, 0.7, 0.03));
  // 40 cm below the knee the heel is 40 cm behind it, 60 degrees up from straight down.
  const Vec3 ankle = bend.posed(joint - 0.4 * Vec3::UnitY());
  EXPECT_LT(
      (ankle - (joint + 0.4 * Vec3(0, -std::cos(60 * degree), -std::sin(60 * degree)))).norm(),
      1e-12);
}

// Half the arc stands on the bisector; the arc's length is R * angle.
TEST(Bend, SectionsFollowTheArc) {
  const double angle = 60 * degree;
  const Bend bend = knee(60);
  const double radius = 0.07 / std::tan(angle / 2);
  double length = 0;
  constexpr int parts = 2000;
  Vec3 before = bend.posed(Vec3(0.1, 0.57, 0));
  for (int i = 1; i <= parts; ++i) {
    const Vec3 next = bend.posed(Vec3(0.1, 0.57 - 0.14 * i / parts, 0));
    length += (next - before).norm();
    before = next;
  }
  EXPECT_NEAR(length, radius * angle, 1e-7);
  // Distances within a section are kept, and its normal is turned with it.
  const Vec3 a(0.12, 0.52, 0.04);
  const Vec3 b(0.07, 0.52, -0.05);
  EXPECT_NEAR((bend.posed(a) - bend.posed(b)).norm(), (a - b).norm(), 1e-12);
  const Vec3 normal = bend.turn(a) * Vec3::UnitY();
  EXPECT_NEAR(normal.dot(bend.posed(a) - bend.posed(b)), 0, 1e-12);
  EXPECT_NEAR(normal.dot(Vec3::UnitY()), std::cos(angle * 0.05 / 0.14), 1e-12);
}

}  // namespace bend_test
}  // namespace toile
