// Measures that the user describes: girths in any plane, distances, heights, curves, slopes.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/measures.h"

namespace toile {

/// Takes the measure that an expression describes: a kind and `key=value` words.
/// - `girth plane=P [tilt=10deg] [roll=5deg]`: in the level plane at P, its front lowered by the
///   tilt, its left by the roll. P is a level (bust, underbust, waist, abdomen, hip), a landmark, a
///   joint, or a height such as 95cm.
/// - `girth part=left_arm share=0.4 [tilt=..] [roll=..]`: square to an arm, a leg, the torso or the
///   head. The share of its length counts from the trunk on, of the torso from the crotch on.
/// - `distance from=A to=B`: straight. `curve from=A to=B`: on the skin.
/// - `height of=A`: above the floor. `slope from=A to=B`: degrees below level from A to B.
/// A and B are landmarks, joints, or points `x,y,z` in metres in the body's own coordinates.
/// `name=N` names the measure; else the expression is its name.
///
/// Throws Error with the place `place` for what is not understood. A landmark that this body lacks
/// leaves a reason.
Measure take_freehand(const BodyShape& shape, const std::string& expression,
                      const std::string& place);

}  // namespace toile
