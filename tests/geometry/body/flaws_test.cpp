#include "geometry/body/flaws.h"

#include <gtest/gtest.h>

#include "geometry/body/mannequin/mannequin.h"
#include "tests/support/shapes.h"

namespace toile {
namespace flaws_test {

TEST(Flaws, PartsAreToldByTheNearestBone) {
  const Skeleton skeleton = make_mannequin({}).skeleton;
  const auto between = [&](const char* from, const char* to) -> Vec3 {
    return (skeleton.joint(from) + skeleton.joint(to)) / 2;
  };
  EXPECT_EQ(part_near(skeleton, between("left_elbow", "left_wrist")), BodyPart::left_arm);
  EXPECT_EQ(part_near(skeleton, between("right_hip", "right_knee")), BodyPart::right_leg);
  EXPECT_EQ(part_near(skeleton, between("waist", "chest") + Vec3(0, 0, 0.1)), BodyPart::torso);
  EXPECT_EQ(part_near(Skeleton{}, Vec3(0, 1, 0)), BodyPart::none);
}

TEST(Flaws, CrossingsAreCountedMeasuredAndPlaced) {
  TriangleMesh two = test::sphere(0.1, 3);
  EXPECT_FALSE(crossings_of(two, std::nullopt));
  EXPECT_TRUE(is_usable(crossings_of(two, std::nullopt)));
  // A second ball stands in the first one's right side, 1 m above the floor.
  const std::size_t points = two.points.size();
  const std::size_t triangles = two.triangles.size();
  for (std::size_t i = 0; i < points; ++i) {
    two.points.push_back(two.points[i] + Vec3(0.19, 1, 0));
    two.points[i].y() += 1;
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    Triangle copy = two.triangles[t];
    for (int& corner : copy) corner += static_cast<int>(points);
    two.triangles.push_back(copy);
  }
  const auto found = crossings_of(two, make_mannequin({}).skeleton);
  ASSERT_TRUE(found);
  EXPECT_GT(found->pairs, 10);
  EXPECT_GT(found->area_share, 0.01);
  EXPECT_LT(found->area_share, 0.3);
  EXPECT_NEAR(found->low, 0.96, 0.04);
  EXPECT_NEAR(found->high, 1.04, 0.04);
  EXPECT_EQ(found->part, BodyPart::torso);
  Crossings many = *found;
  many.area_share = 0.5;
  EXPECT_FALSE(is_usable(many));
  many.area_share = 0.001;
  EXPECT_TRUE(is_usable(many));
}

}  // namespace flaws_test
}  // namespace toile
