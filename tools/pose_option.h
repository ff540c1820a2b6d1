// --pose, of the programs that pose a body.
#pragma once

#include <string>

#include "geometry/body/pose.h"

namespace toile {

/// Whether --pose gives a file, not a name.
bool is_pose_file(const std::string& given);

/// The pose that --pose names, or that its file holds. Sitting and reaching are no poses of the
/// mannequin. Throws UsageError for another name, and as read_pose() does.
Pose pose_of(const std::string& given, PosedFigure figure);

}  // namespace toile
