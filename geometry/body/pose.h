// How a body holds its limbs: plain data, in degrees.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace toile {

/// The joint angles of one side, degrees; 0 is upright with arms and legs hanging straight down,
/// palms inward. At hip and shoulder the limb is first turned about its own length, then raised
/// sideways, then swung forward: rotation about the bone, abduction about z, flexion about x.
struct SidePose {
  double hip_flexion = 0;          ///< thigh forward
  double hip_abduction = 0;        ///< thigh outward
  double hip_rotation = 0;         ///< toes outward
  double knee_flexion = 0;         ///< heel backward
  double ankle_flexion = 0;        ///< toes down, against the shin
  double toes_extension = 0;       ///< toes up, against the foot: what a lifted heel asks for
  double shoulder_flexion = 0;     ///< arm forward
  double shoulder_abduction = 45;  ///< arm outward
  double shoulder_rotation = 0;    ///< thumb outward
  double elbow_flexion = 0;        ///< forearm forward, where the thumb points

  bool operator==(const SidePose&) const = default;
};

struct Pose {
  SidePose left;
  SidePose right;

  bool operator==(const Pose&) const = default;
};

/// A way in which a joint moves, how files call it, and how far it does, degrees. Beyond that the
/// mannequin's sections would fold or its limbs meet.
struct JointMotion {
  std::string_view joint;
  std::string_view motion;
  double SidePose::*angle;
  double min;
  double max;
};

inline constexpr std::array<JointMotion, 10> joint_motions = {{
    {"hip", "flexion", &SidePose::hip_flexion, -30, 60},
    {"hip", "abduction", &SidePose::hip_abduction, -3, 40},
    {"hip", "rotation", &SidePose::hip_rotation, -30, 45},
    {"knee", "flexion", &SidePose::knee_flexion, 0, 80},
    {"ankle", "flexion", &SidePose::ankle_flexion, -25, 45},
    {"toes", "extension", &SidePose::toes_extension, 0, 45},
    {"shoulder", "flexion", &SidePose::shoulder_flexion, -45, 90},
    {"shoulder", "abduction", &SidePose::shoulder_abduction, 25, 80},
    {"shoulder", "rotation", &SidePose::shoulder_rotation, -60, 60},
    {"elbow", "flexion", &SidePose::elbow_flexion, 0, 90},
}};

/// Upright, arms out at 45 degrees.
Pose standing_pose();

/// A step: the left leg forward on its heel, the right one behind with its knee bent and its heel
/// off the floor; the arms swing against the legs, 30 degrees away from the trunk.
Pose walking_pose();

/// The same with left and right exchanged.
Pose mirrored(const Pose& pose);

/// Throws Error, `name` its place, for an angle that is not finite or beyond its joint's range.
void check_pose(const Pose& pose, const std::string& name);

}  // namespace toile
