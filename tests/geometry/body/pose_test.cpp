#include "geometry/body/pose.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/error.h"

namespace toile {
namespace pose_test {

std::string error_of(const Pose& pose) {
  try {
    check_pose(pose, "stride.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Pose, NamedPosesAreWithinTheJointsRanges) {
  EXPECT_EQ(error_of(standing_pose()), "");
  EXPECT_EQ(error_of(walking_pose()), "");
  for (const Pose& pose : {sitting_pose(), reaching_pose()}) {
    EXPECT_NO_THROW(check_pose(pose, "pose", PosedFigure::body));
    EXPECT_NE(error_of(pose), "");
  }
  EXPECT_EQ(standing_pose(), Pose{});
  EXPECT_FALSE(walking_pose() == standing_pose());
}

TEST(Pose, AStepSwingsArmsAgainstLegs) {
  const Pose walk = walking_pose();
  EXPECT_GT(walk.left.hip_flexion, 0);
  EXPECT_LT(walk.right.hip_flexion, 0);
  EXPECT_LT(walk.left.shoulder_flexion, 0);
  EXPECT_GT(walk.right.shoulder_flexion, 0);
  EXPECT_EQ(mirrored(mirrored(walk)), walk);
  EXPECT_EQ(mirrored(walk).left, walk.right);
}

TEST(Pose, AnglesBeyondAJointAreRefusedByName) {
  for (const JointMotion& motion : joint_motions) {
    for (const double wrong :
         {motion.min - 1, motion.max + 1, std::numeric_limits<double>::quiet_NaN(),
          std::numeric_limits<double>::infinity()}) {
      Pose pose;
      pose.right.*motion.angle = wrong;
      const std::string message = error_of(pose);
      EXPECT_NE(message.find("stride.json: right_" + std::string(motion.joint)), std::string::npos)
          << message;
      EXPECT_NE(message.find(motion.motion), std::string::npos) << message;
    }
  }
}

}  // namespace pose_test
}  // namespace toile
