#include "io/pose_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {
namespace pose_file_test {

namespace fs = std::filesystem;

class PoseFile : public testing::Test {
 protected:
  PoseFile()
      : path_(fs::temp_directory_path() / ("toile-pose-" + std::to_string(getpid()) + ".json")) {}
  ~PoseFile() override { fs::remove(path_); }

  Pose read(const std::string& text) const {
    write_file(path_, text);
    return read_pose(path_);
  }

  void expect_error(const std::string& text, const std::string& words) const {
    try {
      read(text);
      ADD_FAILURE() << text << " was read";
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(words), std::string::npos) << message;
      EXPECT_NE(message.find(path_.string()), std::string::npos) << message;
    }
  }

  fs::path path_;
};

TEST_F(PoseFile, NamesWhatIsNotAsStanding) {
  const Pose pose = read(
      R"({"format": "toile-pose", "version": 1, "units": "degrees", "joints": {
          "left_hip": {"flexion": 22.5, "abduction": 3}, "right_elbow": {"flexion": 15}}})");
  Pose expected = standing_pose();
  expected.left.hip_flexion = 22.5;
  expected.left.hip_abduction = 3;
  expected.right.elbow_flexion = 15;
  EXPECT_EQ(pose, expected);
  EXPECT_EQ(read(R"({"joints": {}})"), standing_pose());
}

TEST_F(PoseFile, EveryMotionOfEveryJoint) {
  for (const JointMotion& motion : joint_motions) {
    const Pose pose =
        read(R"({"joints": {"right_)" + std::string(motion.joint) + R"(": {")" +
             std::string(motion.motion) + "\": " + std::to_string(motion.max) + "}}}");
    EXPECT_EQ(pose.right.*motion.angle, motion.max) << motion.joint << motion.motion;
    EXPECT_EQ(pose.left, standing_pose().left);
  }
}

TEST_F(PoseFile, ErrorsNameTheJoint) {
  expect_error("", "");
  expect_error("[]", "");
  expect_error("{}", "joints");
  expect_error(R"({"joints": {"left_hip": {"flexion": 1}})", "");
  expect_error(R"({"joints": {"tail": {"flexion": 1}}})", "tail");
  expect_error(R"({"joints": {"left_tail": {"flexion": 1}}})", "left_tail");
  expect_error(R"({"joints": {"hip": {"flexion": 1}}})", "hip");
  expect_error(R"({"joints": {"left_knee": {"abduction": 1}}})", "'abduction'");
  expect_error(R"({"joints": {"left_knee": {"flexion": "much"}}})", "left_knee");
  expect_error(R"({"joints": {"left_knee": 20}})", "left_knee");
  expect_error(R"({"joints": {"left_hip": {"flexion": null}}})",
               "left_hip: the angle 'flexion' is null");
  expect_error(R"({"joints": {"left_hip": {"flexion": 1, "abduction": null}}})", "'abduction'");
  expect_error(R"({"joints": {"left_hip": null}})", "left_hip");
  expect_error(R"({"joints": {"left_knee": {"flexion": 170}}})", "left_knee");
  expect_error(R"({"joints": {"left_knee": {"flexion": 1e999}}})", "");
  expect_error(R"({"units": "radians", "joints": {}})", "units");
  expect_error(R"({"format": "toile-body", "joints": {}})", "format");
  expect_error(R"({"joint": {}, "joints": {}})", "'joint'");
}

}  // namespace pose_file_test
}  // namespace toile
