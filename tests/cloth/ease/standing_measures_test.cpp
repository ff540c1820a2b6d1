#include "cloth/ease/standing_measures.h"

#include <gtest/gtest.h>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/measures.h"

namespace toile {
namespace standing_measures_test {

TEST(StandingMeasures, ThoseOfTheSkeletonAreTakenWhereTheBodyHasThem) {
  const Mannequin mannequin = make_mannequin({});
  const TriangleMesh& body = mannequin.surface;
  Skeleton skeleton = mannequin.skeleton;
  const BodyMeasures found = standing_measures(body, skeleton);
  ASSERT_GT(found.girths.size(), 10U);
  skeleton.measures = found;
  skeleton.measures->lengths["left_arm_length"] = 0.123;  // no girth: nobody looks
  EXPECT_EQ(standing_measures(body, skeleton).lengths.at("left_arm_length"), 0.123);
  // A body that is 2 % slimmer has other girths, and is measured anew.
  TriangleMesh slim = body;
  for (Vec3& p : slim.points) p.x() *= 0.98;
  const BodyMeasures of_slim = standing_measures(slim, skeleton);
  EXPECT_LT(of_slim.lengths.at("hip"), found.lengths.at("hip") - 0.005);
  EXPECT_NE(of_slim.lengths.at("left_arm_length"), 0.123);
}

}  // namespace standing_measures_test
}  // namespace toile
