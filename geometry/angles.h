// Degrees and radians.
#pragma once

#include <numbers>

namespace toile {

/// For angles that are read as a product with it. It can differ from to_radians() in the last bit.
inline constexpr double radians_per_degree = std::numbers::pi / 180;

constexpr double to_radians(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double to_degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace toile
