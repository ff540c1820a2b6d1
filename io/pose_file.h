// Reads a pose file: angles of named joints.
#pragma once

#include <filesystem>

#include "geometry/body/pose.h"

namespace toile {

/// Reads a file such as
/// {"format": "toile-pose", "version": 1, "units": "degrees",
///  "joints": {"left_hip": {"flexion": 22, "abduction": 3}, "right_knee": {"flexion": 20}}}
///
/// Joints are those of joint_motions with left_ or right_ before the name. Angles that the file
/// does not name are those of standing_pose(). `format`, `version` and `units` may be left out.
///
/// It throws Error, with the file and the joint, for text that is not JSON and for an unknown key,
/// joint or motion. An angle that is null, no number or beyond its joint's range in the figure is
/// an Error, too.
Pose read_pose(const std::filesystem::path& path, PosedFigure figure = PosedFigure::mannequin);

}  // namespace toile
