// Constants of the scene: hands, flesh, fabrics and their limits.
// docs/constants.md shows what half and double of many of them do.
#pragma once

namespace toile {

/// N/m: the pull of a hand that closes a seam. A seam that takes more is too tight.
inline constexpr double hand_pull = 300;

/// Metres: the breadth of a hand. Tension across a seam is a mean over this length.
inline constexpr double hand_breadth = 0.1;

/// Metres of girth by which the body gives way. A garment that lacks less than this can be worn.
inline constexpr double flesh_give = 0.01;

/// N/m: the largest stretch and shear modulus of a fabric. Stiffer ones are cut to it, with a
/// warning. They move too little in a step to come to rest in any time. Little is lost: a hand's
/// pull of 300 N/m stretches cloth of this modulus by 0.3 %.
inline constexpr double max_modulus = 1e5;

/// Share of the weft's modulus that shear has at least where a modulus across the yarns is asked
/// for. Without shear stiffness that modulus would be 0.
inline constexpr double min_shear_share = 1e-3;

/// Share of its stiffness by which cloth is stiffer beyond its strain limits, besides the
/// multipliers that hold it there. A higher value finds the multipliers sooner, and converges
/// slower.
inline constexpr double strain_limit_stiffening = 1;

/// N/m: the largest multiplier that holds a yarn to its strain limit. It is a hand's pull.
inline constexpr double max_limit_multiplier = hand_pull;

/// Metres of air between the skin and the inner face of the cloth.
inline constexpr double skin_air_gap = 0.001;

/// Metres: two points that a pattern places in one place are nearer than this. Only rounding lies
/// between them.
inline constexpr double same_place = 1e-9;

}  // namespace toile
