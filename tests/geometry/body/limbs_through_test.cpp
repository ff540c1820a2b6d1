#include "geometry/body/limbs_through.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/standing_figure.h"

namespace toile {
namespace limbs_through_test {

/// A circle of 40 points about `centre`, in the plane of `u` and `v`.
std::vector<Vec3> circle(const Vec3& centre, double radius, const Vec3& u, const Vec3& v) {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    points.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return points;
}

const Vec3 x = Vec3::UnitX();
const Vec3 y = Vec3::UnitY();
const Vec3 z = Vec3::UnitZ();

LimbsThrough level_circle(double height, double radius, double across = 0) {
  return limbs_through(circle({across, height, 0}, radius, x, z), test::figure());
}

TEST(LimbsThrough, NecklineHemAndLegs) {
  EXPECT_EQ(level_circle(1.45, 0.1), through_neckline);
  EXPECT_EQ(level_circle(1.1, 0.25), through_hem);  // below the arms
  EXPECT_EQ(level_circle(0.4, 0.3), through_hem);   // around both knees
  EXPECT_EQ(level_circle(-0.2, 0.3), through_hem);  // below the feet
  EXPECT_EQ(level_circle(0.4, 0.08, 0.1), (LimbsThrough{false, false, true, false}));
  EXPECT_EQ(level_circle(0.4, 0.08, -0.1), (LimbsThrough{false, false, false, true}));
}

TEST(LimbsThrough, Cuffs) {
  const auto cuff = [](double at) {
    return limbs_through(circle({at, 1.3, 0}, 0.07, y, z), test::figure());
  };
  for (const double at : {0.3, 0.5, 0.75}) {
    EXPECT_EQ(cuff(at), (LimbsThrough{true, false, false, false})) << at;
    EXPECT_EQ(cuff(-at), (LimbsThrough{false, true, false, false})) << at;
  }
}

TEST(LimbsThrough, NothingBesideTheBody) {
  EXPECT_FALSE(level_circle(1.1, 0.1, 0.4).any());
  EXPECT_FALSE(level_circle(2.5, 0.5).any());
  // In front of the body, standing upright.
  EXPECT_FALSE(limbs_through(circle({0, 1.1, 0.4}, 0.2, x, y), test::figure()).any());
}

TEST(LimbsThrough, TheSenseOfTheLoopPlaysNoPart) {
  EXPECT_EQ(limbs_through(circle({0, 1.1, 0}, 0.25, z, x), test::figure()), through_hem);
}

TEST(LimbsThrough, AHoodsOpeningStandsBeforeTheFace) {
  // From the front of the neck over the forehead.
  EXPECT_EQ(limbs_through(circle({0, 1.55, 0.12}, 0.13, x, y), test::figure()), through_neckline);
}

TEST(LimbsThrough, ATiltedAndWavyHemIsAHem) {
  std::vector<Vec3> hem = circle({0, 0.9, 0}, 0.4, x, z);
  for (std::size_t i = 0; i < hem.size(); ++i) {
    hem[i].y() += 0.3 * hem[i].x() + 0.1 * std::sin(5.0 * static_cast<double>(i));
  }
  EXPECT_EQ(limbs_through(hem, test::figure()), through_hem);
}

TEST(LimbsThrough, AMissingJointIsNamed) {
  Skeleton skeleton = test::figure();
  EXPECT_TRUE(has_all_limbs(skeleton));
  skeleton.joints.erase("left_elbow");
  EXPECT_FALSE(has_all_limbs(skeleton));
  EXPECT_THROW(limbs_through(circle({0, 1.1, 0}, 0.25, x, z), skeleton), Error);
}

}  // namespace limbs_through_test
}  // namespace toile
