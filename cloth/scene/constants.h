// What hands and flesh can do: constants of dressing that several rooms share.
#pragma once

namespace toile {

/// N per metre of seam: the pull of a hand that closes a seam. Also the most that holds a yarn to
/// its strain limit. A garment that takes more is too tight there.
inline constexpr double hand_pull = 300;

/// Metres: the breadth of a hand. Tension across a seam is a mean over this length.
inline constexpr double hand_breadth = 0.1;

/// Metres of girth that the body gives way by: a garment that lacks less can be worn.
inline constexpr double flesh_give = 0.01;

}  // namespace toile
