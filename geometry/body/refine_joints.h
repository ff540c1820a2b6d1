// Joints, to a few millimetres also on noisy surfaces: by fits over many sections.
#pragma once

#include <optional>

#include "geometry/body/body_frame.h"

namespace toile {

/// Moves the joints of a frame that has a skeleton: the pelvis to the crotch's height and the hips
/// as far, and knees, wrists and elbows along their limbs. Returns the crotch's place in the
/// frame, as find_crotch() finds it. Costs some 200 slices.
std::optional<Vec3> refine_joints(BodyFrame& frame);

}  // namespace toile
