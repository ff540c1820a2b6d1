// Which parts of a body's skin move rigidly with one bone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// The rigid parts of a body. The trunk includes neck and head, the forearm the hand. Each side has
/// its own of all but the trunk.
enum class Bone { trunk, upper_arm, forearm, thigh, shin, foot, toes };
inline constexpr int bones_of_side = 6;
inline constexpr int bone_count = 1 + 2 * bones_of_side;

/// The index of a bone in [0, bone_count): the trunk, then those of the left, then of the right.
inline constexpr int bone_index(Bone bone, bool left) {
  return bone == Bone::trunk ? 0 : static_cast<int>(bone) + (left ? 0 : bones_of_side);
}

/// What the skin tells of a foot beyond the skeleton.
struct FootShape {
  Vec3 along = Vec3::UnitZ();  ///< unit vector from heel to toes, level
  Vec3 ball = Vec3::Zero();    ///< metres: a point of the line across the ball, on the sole
};

struct SkinCores {
  std::vector<int> bone_of;       ///< per point a bone_index(), or no_bone near a joint
  std::array<FootShape, 2> feet;  ///< left, right

  static constexpr int no_bone = -1;
};

/// The core of each bone: the skin that lies too far from its joints to bend with them.
///
/// `body` stands with arms and legs apart. It is closed, in metres, in the skeleton's frame. The
/// skeleton has all of joint_names. It throws Error, with the place `name`, where an arm or a leg
/// can't be told from the trunk. It costs up to 60 walks over an arm's skin.
SkinCores skin_cores(const TriangleMesh& body, const Skeleton& skeleton, const std::string& name);

}  // namespace toile
