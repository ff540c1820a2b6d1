#include "geometry/body/pose_body.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "geometry/body/find_skeleton.h"
#include "geometry/body/limb_girths.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/closed_surface.h"
#include "geometry/error.h"
#include "geometry/intersections.h"

namespace toile {
namespace pose_body_test {

const Mannequin& standing() {
  static const Mannequin made = make_mannequin({.edge_length = 0.012});
  return made;
}

PosedBody posed(const Pose& pose) {
  return pose_body(standing().surface, standing().skeleton, pose, "mannequin");
}

Pose arms_down() {
  Pose pose;
  pose.left.shoulder_abduction = pose.right.shoulder_abduction = 20;
  return pose;
}

double forward_degrees(const Skeleton& skeleton, const std::string& from, const std::string& to) {
  const Vec3 bone = skeleton.joint(to) - skeleton.joint(from);
  return std::atan2(bone.z(), -bone.y()) * 180 / std::numbers::pi;
}

TEST(PoseBody, StaysClosedFreeOfCrossingsAndOfItsGirths) {
  for (const auto& [name, pose] :
       std::vector<std::pair<std::string, Pose>>{{"walking", walking_pose()},
                                                 {"sitting", sitting_pose()},
                                                 {"reaching", reaching_pose()},
                                                 {"arms down", arms_down()}}) {
    const PosedBody body = posed(pose);
    EXPECT_EQ(closed_surface_defect(body.surface), "") << name;
    EXPECT_TRUE(self_intersections(body.surface).empty()) << name;
    EXPECT_EQ(body.crossings.pairs_left, 0) << name;
    double floor = 1;
    for (const Vec3& p : body.surface.points) floor = std::min(floor, p.y());
    EXPECT_EQ(floor, 0) << name;
    double worst = 0;
    for (const LimbGirth& girth :
         limb_girths(standing().surface, standing().skeleton, body.surface, body.skeleton)) {
      const double change = girth.posed / girth.standing - 1;
      worst = std::max(worst, std::abs(change));
      EXPECT_LT(std::abs(change), 0.03) << name << ": " << girth.name;
    }
    std::cout << name << ": girths change by at most " << 100 * worst << " %\n";
  }
}

TEST(PoseBody, JointsAreWhereThePosePutsThem) {
  const Skeleton& before = standing().skeleton;
  for (const Pose& pose : {walking_pose(), sitting_pose(), reaching_pose(), arms_down()}) {
    const Skeleton after = posed(pose).skeleton;
    for (const Segment& bone : after.segments) {
      EXPECT_NEAR((after.joint(bone.to) - after.joint(bone.from)).norm(),
                  (before.joint(bone.to) - before.joint(bone.from)).norm(), 1e-12);
    }
    for (const bool left : {true, false}) {
      const std::string side = left ? "left_" : "right_";
      const SidePose& angles = left ? pose.left : pose.right;
      const auto swung = [&](const std::string& from, const std::string& to) {
        return forward_degrees(after, side + from, side + to) -
               forward_degrees(before, side + from, side + to);
      };
      EXPECT_NEAR(swung("hip", "knee"), angles.hip_flexion, 1e-9);
      EXPECT_NEAR(swung("knee", "ankle"), angles.hip_flexion - angles.knee_flexion, 1);
      EXPECT_NEAR(forward_degrees(after, side + "shoulder", side + "elbow"),
                  angles.shoulder_flexion, 1e-9);
      const Vec3 arm = (after.joint(side + "elbow") - after.joint(side + "shoulder")).normalized();
      EXPECT_NEAR(std::asin((left ? 1 : -1) * arm.x()) * 180 / std::numbers::pi,
                  angles.shoulder_abduction, 1e-9);
    }
  }
}

// The posed skin lies about the posed bones: hands and feet are where the skeleton says.
TEST(PoseBody, HasNoMeasuresOfTheBodyThatStood) {
  Skeleton skeleton = standing().skeleton;
  skeleton.measures.emplace();
  skeleton.measures->lengths["hip"] = 1;
  EXPECT_FALSE(
      pose_body(standing().surface, skeleton, walking_pose(), "mannequin").skeleton.measures);
}

TEST(PoseBody, TheSkinGoesWithTheBones) {
  const PosedBody body = posed(sitting_pose());
  const auto nearest = [&body](const Vec3& joint) {
    double least = 1;
    for (const Vec3& p : body.surface.points) least = std::min(least, (p - joint).norm());
    return least;
  };
  for (const std::string joint : {"left_wrist", "right_wrist", "left_ankle", "right_knee"}) {
    EXPECT_LT(nearest(body.skeleton.joint(joint)), 0.06) << joint;
  }
  // The crotch stays below the trunk, between the thighs.
  const double lowered =
      standing().skeleton.joint("pelvis").y() - body.skeleton.joint("pelvis").y();
  EXPECT_LT(nearest(body.skeleton.joint("pelvis")), 0.03);
  EXPECT_NEAR(lowered, 0.37, 0.05);
}

TEST(PoseBody, HasTheSameBitsForAnyNumberOfThreads) {
  const auto made = [](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return posed(sitting_pose()).surface.points;
  };
  const std::vector<Vec3> one = made(1);
  EXPECT_EQ(one, made(2));
  EXPECT_EQ(one, made(5));
}

TEST(PoseBody, LimbsThatGoThroughEachOtherAreCountedAndLeft) {
  Pose pose;
  pose.left.shoulder_abduction = -30;
  const PosedBody body = posed(pose);
  EXPECT_GT(body.crossings.pairs_left, 0);
  EXPECT_EQ(body.crossings.pairs_left, static_cast<int>(self_intersections(body.surface).size()));
  EXPECT_EQ(body.crossings.largest_move, 0);
}

TEST(PoseBody, BodiesThatCantBePosedAreRefused) {
  const auto error_of = [](const TriangleMesh& body, const Skeleton& skeleton) -> std::string {
    try {
      pose_body(body, skeleton, walking_pose(), "body.ply");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  Skeleton lacking = standing().skeleton;
  lacking.joints.erase("left_knee");
  EXPECT_NE(error_of(standing().surface, lacking).find("lacks joints"), std::string::npos);
  // A crotch that is stated far too high makes one part of both legs and the trunk.
  Skeleton high = standing().skeleton;
  high.joints["pelvis"].y() = 1.0;
  EXPECT_NE(error_of(standing().surface, high).find("leg can't be told"), std::string::npos);
}

TEST(PoseBody, WhoSitsIsNotTakenForStanding) {
  try {
    find_skeleton(posed(sitting_pose()).surface, "sits");
    FAIL() << "a skeleton was found";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("upright"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(find_skeleton(posed(walking_pose()).surface, "walks"));
}

}  // namespace pose_body_test
}  // namespace toile
