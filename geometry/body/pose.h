// The pose of a body as joint angles in degrees: plain data.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace toile {

/// The joint angles of one side, degrees. All 0 is upright with arms and legs hanging straight
/// down, palms inward. Hip and shoulder turn the limb about the bone first (rotation). Then they
/// raise it sideways about z (abduction) and swing it forward about x (flexion).
struct SidePose {
  double hip_flexion = 0;          ///< thigh forward
  double hip_abduction = 0;        ///< thigh outward
  double hip_rotation = 0;         ///< toes outward
  double knee_flexion = 0;         ///< heel backward
  double ankle_flexion = 0;        ///< toes down, against the shin
  double toes_extension = 0;       ///< toes up, against the foot, as under a lifted heel
  double shoulder_flexion = 0;     ///< arm forward
  double shoulder_abduction = 45;  ///< arm outward
  double shoulder_rotation = 0;    ///< thumb outward
  double elbow_flexion = 0;        ///< forearm forward, toward the thumb

  bool operator==(const SidePose&) const = default;
};

struct Pose {
  SidePose left;
  SidePose right;

  bool operator==(const Pose&) const = default;
};

/// One motion of a joint and its ranges, degrees.
struct JointMotion {
  std::string_view joint;   ///< name in files, without left_ or right_
  std::string_view motion;  ///< name in files
  double SidePose::*angle;
  double min;  ///< beyond [min, max] the mannequin's sections would fold or its limbs meet
  double max;
  double body_min;  ///< beyond [body_min, body_max] few people's joints go
  double body_max;
};

inline constexpr std::array<JointMotion, 10> joint_motions = {{
    {"hip", "flexion", &SidePose::hip_flexion, -30, 60, -30, 120},
    {"hip", "abduction", &SidePose::hip_abduction, -3, 40, -20, 45},
    {"hip", "rotation", &SidePose::hip_rotation, -30, 45, -45, 45},
    {"knee", "flexion", &SidePose::knee_flexion, 0, 80, 0, 130},
    {"ankle", "flexion", &SidePose::ankle_flexion, -25, 45, -25, 45},
    {"toes", "extension", &SidePose::toes_extension, 0, 45, 0, 45},
    {"shoulder", "flexion", &SidePose::shoulder_flexion, -45, 90, -50, 170},
    {"shoulder", "abduction", &SidePose::shoulder_abduction, 25, 80, -30, 150},
    {"shoulder", "rotation", &SidePose::shoulder_rotation, -60, 60, -80, 80},
    {"elbow", "flexion", &SidePose::elbow_flexion, 0, 90, 0, 140},
}};

/// Whose joints a pose has to suit: the mannequin's, or those of any body that pose_body() poses.
enum class PosedFigure { mannequin, body };

/// The body upright, arms out at 45 degrees.
Pose standing_pose();

/// A step. The left leg is forward on its heel. The right one is behind with its knee bent and its
/// heel off the floor. The arms swing against the legs, 30 degrees away from the trunk.
Pose walking_pose();

/// On a chair: hips and knees bent by 90 degrees, the arms 30 degrees away from the trunk. It is
/// beyond the mannequin's ranges.
Pose sitting_pose();

/// The right arm reaches up and forward, 150 degrees from hanging. The left one hangs, 30 degrees
/// away from the trunk. It is beyond the mannequin's ranges.
Pose reaching_pose();

/// The pose with left and right exchanged.
Pose mirrored(const Pose& pose);

/// Throws Error, with the place `name`, for an angle that is not finite or outside the range that
/// its joint has in the figure.
void check_pose(const Pose& pose, const std::string& name,
                PosedFigure figure = PosedFigure::mannequin);

}  // namespace toile
