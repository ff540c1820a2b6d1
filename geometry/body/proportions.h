// Proportions of the body that place joints where no shape shows them.
#pragma once

namespace toile {

/// Upper arm, forearm and hand, as shares of the body's height: the segment lengths of [Drillis &
/// Contini 1966] as every ergonomics table has them.
inline constexpr double upper_arm_share = 0.186;
inline constexpr double forearm_share = 0.146;
inline constexpr double hand_share = 0.108;

/// The elbow, as a share of the length from shoulder to wrist.
inline constexpr double elbow_share = upper_arm_share / (upper_arm_share + forearm_share);

/// The knee, as a share of the crotch's height.
inline constexpr double knee_share = 0.61;

/// Between a knee's thin place and what proportion says at most, as a share of the height. At half
/// of it, two knees of five bodies move by 15 and 21 mm, at double none.
inline constexpr double knee_span = 0.04;

}  // namespace toile
