#include "io/pose_file.h"

#include <algorithm>

#include "io/json_value.h"
#include "io/output_file.h"

namespace toile {

namespace {

/// `so_far`, a list such as "a, b", with `name` appended unless it is the last one already.
std::string list(const std::string& so_far, std::string_view name) {
  if (so_far == name || so_far.ends_with(", " + std::string(name))) return so_far;
  return so_far + (so_far.empty() ? "" : ", ") + std::string(name);
}

std::string known_joints() {
  std::string names;
  for (const JointMotion& motion : joint_motions) names = list(names, motion.joint);
  return "left_ or right_ and one of " + names;
}

void read_joint(const std::string& joint, const JsonValue& motions, SidePose& side) {
  std::string known;
  for (const JointMotion& motion : joint_motions) {
    if (motion.joint == joint) known = list(known, motion.motion);
  }
  if (known.empty()) motions.fail("is no joint of the mannequin", "use " + known_joints());
  for (const std::string& key : motions.keys()) {
    const auto motion =
        std::find_if(joint_motions.begin(), joint_motions.end(),
                     [&](const JointMotion& m) { return m.joint == joint && m.motion == key; });
    if (motion == joint_motions.end()) {
      motions.fail("'" + key + "' is no motion of this joint", "use " + known);
    }
    if (const auto angle = motions.find(key)) side.*(motion->angle) = angle->number();
  }
}

}  // namespace

Pose read_pose(const std::filesystem::path& path) {
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
  for (const std::string& key : root.keys()) {
    if (key != "format" && key != "version" && key != "units" && key != "joints") {
      root.fail("'" + key + "' is no key of a pose", "name the joints under 'joints'");
    }
  }
  Pose pose = standing_pose();
  const JsonValue joints = root.get("joints");
  for (const std::string& key : joints.keys()) {
    const JsonValue motions = joints.get(key).called(name + ": " + key);
    if (key.starts_with("left_")) {
      read_joint(key.substr(5), motions, pose.left);
    } else if (key.starts_with("right_")) {
      read_joint(key.substr(6), motions, pose.right);
    } else {
      motions.fail("is no joint of the mannequin", "use " + known_joints());
    }
  }
  check_pose(pose, name);
  return pose;
}

}  // namespace toile
