#include "cloth/start/turn_and_lift.h"

#include <gtest/gtest.h>

#include "tests/cloth/figure.h"
#include "tests/support/shapes.h"

namespace toile {
namespace turn_and_lift_test {

using test::figure;

/// Two panels before and behind a body of 1 m, sewn along their upper edge at height `top`.
PanelMesh sandwich(double top) {
  PanelMesh garment;
  for (const double z : {0.2, -0.2}) {
    test::add_panel(garment, z > 0 ? "front" : "back", test::grid(0.2, 0.3, 8, 12),
                    [&](const Vec2& p) { return Vec3(p.x() - 0.1, top - 0.3 + p.y(), z); });
  }
  std::vector<int> front, back;
  for (int i = 0; i <= 8; ++i) {
    front.push_back(12 * 9 + i);
    back.push_back(13 * 9 + 12 * 9 + i);
  }
  garment.seams = {test::seam("shoulder", front, back)};
  return garment;
}

TEST(Placement, SeamsAreLiftedUntilTheyMeetOutsideTheBody) {
  const DistanceGrid body{SurfaceDistance(test::box({-0.15, 0, -0.1}, {0.15, 1, 0.1}))};
  // Half-way between the panels the seam is 5 cm deep. 6 cm clear it by the 1 cm that it has to
  // have, and the cloth gets 3 cm more to come down.
  const PanelMesh low = sandwich(0.955);
  const Placement lifted = turn_and_lift(low, body, nullptr);
  EXPECT_NEAR(lifted.lift, 0.09, 1e-12);
  EXPECT_EQ(lifted.seams_inside, 0);
  EXPECT_EQ(lifted.points_inside, 0);
  for (std::size_t p = 0; p < low.placed.size(); ++p) {
    EXPECT_LT((lifted.placed[p] - low.placed[p] - Vec3(0, lifted.lift, 0)).norm(), 1e-15);
  }
  const PanelMesh high = sandwich(1.05);
  const Placement still = turn_and_lift(high, body, nullptr);
  EXPECT_EQ(still.lift, 0);
  EXPECT_EQ(still.placed, high.placed);
}

TEST(Placement, SeamsAreLiftedUntilNeitherSideHasToComeThroughTheBody) {
  // The sides meet in front of the body, but the back has to come through it. So it is lifted up to
  // the body's top at 1 m, which is 4.5 cm above the seam.
  const DistanceGrid body{SurfaceDistance(test::box({-0.15, 0, -0.16}, {0.15, 1, -0.04}))};
  const Placement lifted = turn_and_lift(sandwich(0.955), body, nullptr);
  EXPECT_NEAR(lifted.lift, 0.05 + 0.03, 1e-12);
}

TEST(Placement, SleevesAreNotLiftedOffTheirArms) {
  const TriangleMesh torso = test::box({-0.1, 0, -0.1}, {0.1, 1.5, 0.1});
  const DistanceGrid body{
      SurfaceDistance(test::together(torso, test::box({0.15, 1.26, -0.04}, {0.7, 1.34, 0.04})))};
  const Skeleton skeleton = figure();
  const auto placed_at = [&](double bottom, const Skeleton* known) {
    PanelMesh garment;
    for (const double z : {0.1, -0.1}) {
      test::add_panel(garment, z > 0 ? "front" : "back", test::grid(0.2, 0.2, 8, 8),
                      [&](const Vec2& p) { return Vec3(0.3 + p.x(), bottom + p.y(), z); })
          .is = classify({"", BodyPart::left_arm});
    }
    std::vector<int> lower;
    for (int i = 0; i <= 8; ++i) lower.push_back(i);
    std::vector<int> behind = lower;
    for (int& p : behind) p += 81;
    garment.seams = {test::seam("under the arm", lower, behind)};
    return turn_and_lift(garment, body, known).lift;
  };
  // The seam below the arm would have to come through it, and could be lifted above it.
  EXPECT_EQ(placed_at(1.275, &skeleton), 0);
  EXPECT_NEAR(placed_at(1.275, nullptr), 0.08 + 0.03, 1e-12);
}

TEST(Placement, ASkirtIsNotLiftedIntoTheArms) {
  const TriangleMesh torso = test::box({-0.15, 0, -0.1}, {0.15, 1, 0.1});
  const TriangleMesh arms = test::together(test::box({-0.2, 1, 0.15}, {0.2, 1.1, 0.25}),
                                           test::box({-0.2, 1, -0.25}, {0.2, 1.1, -0.15}));
  const DistanceGrid body{SurfaceDistance(test::together(torso, arms))};
  const Skeleton skeleton = figure();
  const Placement placement = turn_and_lift(sandwich(0.955), body, &skeleton);
  EXPECT_EQ(placement.lift, 0);
  EXPECT_EQ(placement.points_inside, 0);
  EXPECT_EQ(placement.seams_inside, 9);
}

TEST(Placement, ASeamThatNoLiftClearsStays) {
  const DistanceGrid body{SurfaceDistance(test::box({-0.15, 0, -0.1}, {0.15, 1, 0.1}))};
  const Placement placement = turn_and_lift(sandwich(0.5), body, nullptr);
  EXPECT_EQ(placement.lift, 0);
  EXPECT_EQ(placement.seams_inside, 9);
}

TEST(Placement, PointsInsideTheBodyAreCounted) {
  const DistanceGrid body{SurfaceDistance(test::box({-0.15, 0, -0.1}, {0.15, 1, 0.1}))};
  PanelMesh garment = sandwich(1.06);
  for (int p = 0; p < 13 * 9; ++p) garment.placed[p].z() = 0;
  // Rows at 0.76 to 1.06 in steps of 25 mm: ten lie below the top.
  EXPECT_EQ(turn_and_lift(garment, body, nullptr).points_inside, 9 * 10);
}

}  // namespace turn_and_lift_test
}  // namespace toile
