// The landmarks of arms and legs, and what all landmarks share.
#pragma once

#include <optional>
#include <string>

#include "geometry/body/find_landmarks.h"

namespace toile {

/// The left side is 1, the right -1.
inline std::string side_prefix(int side) { return side > 0 ? "left_" : "right_"; }

/// Adds a landmark. Without a place its confidence is 0 and it has a reason: that its outline is
/// not closed, where none is given.
void add_landmark(Landmarks& landmarks, const std::string& name, const std::optional<Vec3>& place,
                  double confidence, const std::string& reason = "");

/// Adds gluteal folds, knees, calves, ankles, elbows and wrists to `shape.landmarks`, of arms only
/// those that `shape.frame` does not lack. `shape.frame` has a skeleton; the seat points are there.
void find_limb_landmarks(BodyShape& shape);

}  // namespace toile
