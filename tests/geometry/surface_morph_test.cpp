#include "geometry/surface_morph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "geometry/error.h"

namespace toile {
namespace surface_morph_test {

using std::numbers::pi;

constexpr int rings = 60;
constexpr int around = 12;
constexpr double radius = 0.03;

/// A tube of length 1, open at both ends. `frame` is where a ring's middle is at a share of the
/// length, and how its plane is turned from square to x.
struct Frame {
  Vec3 middle;
  double turn;  // radians about z
};
TriangleMesh tube(const std::function<Frame(double)>& frame) {
  TriangleMesh mesh;
  for (int i = 0; i <= rings; ++i) {
    const Frame at = frame(static_cast<double>(i) / rings);
    const Eigen::AngleAxisd turn(at.turn, Vec3::UnitZ());
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * pi * j / around;
      mesh.points.push_back(at.middle +
                            turn * Vec3(0, radius * std::cos(angle), radius * std::sin(angle)));
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      const int a = i * around + j;
      const int b = i * around + (j + 1) % around;
      mesh.triangles.push_back({a, b, a + around});
      mesh.triangles.push_back({b, b + around, a + around});
    }
  }
  return mesh;
}

TriangleMesh straight() {
  return tube([](double share) { return Frame{{share, 0, 0}, 0}; });
}

/// Bent evenly by `angle` radians from a third of the length on.
TriangleMesh bent(double angle) {
  return tube([angle](double share) {
    const double from = 1.0 / 3;
    if (share < from) return Frame{{share, 0, 0}, 0};
    const double turned = angle * (share - from) / (1 - from);
    const double r = (1 - from) / angle;
    return Frame{{from + r * std::sin(turned), r * (1 - std::cos(turned)), 0}, turned};
  });
}

Vec3 end_of(const TriangleMesh& mesh) {
  Vec3 sum = Vec3::Zero();
  for (int j = 0; j < around; ++j) sum += mesh.points[rings * around + j];
  return sum / around;
}

TEST(SurfaceMorph, HalfwayALimbIsBentByHalf) {
  for (const double degrees : {90.0, 150.0, 270.0, 330.0}) {
    const TriangleMesh end = bent(degrees * pi / 180);
    const SurfaceMorph morph(straight(), end, "limb");
    for (const double share : {0.25, 0.5, 0.75}) {
      const TriangleMesh there = morph.at(share);
      const Vec3 wanted = end_of(bent(share * degrees * pi / 180));
      EXPECT_LT((end_of(there) - wanted).norm(), 0.002) << degrees << ", " << share;
      const Eigen::AngleAxisd turn(morph.turn(static_cast<int>(end.triangles.size()) - 1, share));
      const double whole = std::min(share * degrees, 360 - share * degrees);
      EXPECT_NEAR(turn.angle() * 180 / pi, whole, 0.02 * degrees) << degrees << ", " << share;
    }
  }
}

TEST(SurfaceMorph, EndsHaveTheBitsOfTheShapes) {
  const TriangleMesh end = bent(2);
  const SurfaceMorph morph(straight(), end, "limb");
  EXPECT_EQ(morph.at(0).points, straight().points);
  EXPECT_EQ(morph.at(1).points, end.points);
  // The solved surface comes to the same end.
  const TriangleMesh near = morph.at(1 - 1e-9);
  for (std::size_t i = 0; i < end.points.size(); ++i) {
    EXPECT_LT((near.points[i] - end.points[i]).norm(), 1e-7);
  }
}

TEST(SurfaceMorph, EachPartGoesItsOwnWay) {
  TriangleMesh from = straight();
  TriangleMesh to = bent(1);
  append(from, straight());
  append(to, straight());
  for (std::size_t i = to.points.size() / 2; i < to.points.size(); ++i) to.points[i].z() += 0.4;
  const TriangleMesh halfway = SurfaceMorph(from, to, "limbs").at(0.5);
  for (std::size_t i = to.points.size() / 2; i < to.points.size(); ++i) {
    EXPECT_LT((halfway.points[i] - from.points[i] - Vec3(0, 0, 0.2)).norm(), 1e-9);
  }
}

TEST(SurfaceMorph, LoosePointsGoStraight) {
  TriangleMesh from = straight();
  TriangleMesh to = bent(1);
  from.points.emplace_back(1, 2, 3);
  to.points.emplace_back(1, 2, 5);
  EXPECT_LT((SurfaceMorph(from, to, "limb").at(0.5).points.back() - Vec3(1, 2, 4)).norm(), 1e-9);
}

TEST(SurfaceMorph, OtherTrianglesAreAnError) {
  TriangleMesh other = straight();
  other.triangles.pop_back();
  EXPECT_THROW(SurfaceMorph(straight(), other, "body.ply"), Error);
}

}  // namespace surface_morph_test
}  // namespace toile
