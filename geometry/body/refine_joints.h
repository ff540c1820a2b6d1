// Joints, to a few millimetres also on noisy surfaces: by fits over many sections.
#pragma once

#include <optional>

#include "geometry/body/body_frame.h"

namespace toile {

/// Moves joints of a frame that has a skeleton. The pelvis comes to the crotch's height, the hips
/// move as far, the chest comes to the armpits' height. Knees, wrists and elbows move along their
/// limbs. Returns the crotch's place in the frame, as find_crotch() finds it. Costs some 250
/// slices.
std::optional<Vec3> refine_joints(BodyFrame& frame);

}  // namespace toile
