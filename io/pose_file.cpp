#include "io/pose_file.h"

#include <string>
#include <string_view>
#include <vector>

#include "io/json_value.h"
#include "io/json_words.h"
#include "io/output_file.h"

namespace toile {

namespace {

std::string known_joints() {
  std::vector<std::string_view> names;
  for (const JointMotion& motion : joint_motions) {
    if (names.empty() || names.back() != motion.joint) names.push_back(motion.joint);
  }
  return "left_ or right_ and one of " + listed(names);
}

void read_joint(const std::string& joint, const JsonValue& motions, SidePose& side) {
  std::vector<std::string_view> known;
  for (const JointMotion& motion : joint_motions) {
    if (motion.joint == joint) known.push_back(motion.motion);
  }
  if (known.empty()) motions.fail("is no joint of a pose", "use " + known_joints());
  refuse_other_keys(motions, known);
  for (const std::string& key : motions.keys()) {
    if (motions.find(key)) continue;
    motions.fail("the angle " + in_quotes(key) + " is null", "give it in degrees, or leave it out");
  }
  for (const JointMotion& motion : joint_motions) {
    if (motion.joint != joint) continue;
    const auto angle = motions.find(std::string(motion.motion));
    if (angle) side.*(motion.angle) = angle->number();
  }
}

}  // namespace

Pose read_pose(const std::filesystem::path& path, PosedFigure figure) {
  const std::string name = path.string();
  const JsonDocument document(read_file(path), name);
  const JsonValue root = document.root();
  const auto expect = [&root](const std::string& key, const std::string& text) {
    const auto value = root.find(key);
    if (value && value->text() != text) value->fail("is not '" + text + "'");
  };
  expect("format", "toile-pose");
  expect("units", "degrees");
  if (const auto version = root.find("version"); version && version->number() != 1) {
    version->fail("is not 1");
  }
  refuse_other_keys(root, std::vector<std::string>{"format", "version", "units", "joints"});
  Pose pose = standing_pose();
  const JsonValue joints = root.get("joints");
  for (const std::string& key : joints.keys()) {
    const JsonValue motions = joints.get(key).called(name + ": " + key);
    if (key.starts_with("left_")) {
      read_joint(key.substr(5), motions, pose.left);
    } else if (key.starts_with("right_")) {
      read_joint(key.substr(6), motions, pose.right);
    } else {
      motions.fail("is no joint of a pose", "use " + known_joints());
    }
  }
  check_pose(pose, name, figure);
  return pose;
}

}  // namespace toile
