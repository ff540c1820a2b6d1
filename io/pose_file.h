// A pose on disk: angles of named joints.
#pragma once

#include <filesystem>

#include "geometry/body/pose.h"

namespace toile {

/// {"format": "toile-pose", "version": 1, "units": "degrees",
///  "joints": {"left_hip": {"flexion": 22, "abduction": 3}, "right_knee": {"flexion": 20}}}
///
/// Joints are those of joint_motions with left_ or right_ before; what a file does not name is as
/// standing. `format`, `version` and `units` may be left out. Throws Error, naming the file and the
/// joint, for what is no JSON, an unknown key, joint or motion, an angle that is no number, or one
/// beyond its joint's range.
Pose read_pose(const std::filesystem::path& path);

}  // namespace toile
