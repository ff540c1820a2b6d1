// Numbers that look random and are the same each time: splitmix64 (Steele, Lea, Flood 2014).
#pragma once

#include <cstdint>

namespace toile {

/// What is added to the state before each number.
inline constexpr std::uint64_t golden_step = 0x9E3779B97F4A7C15U;

/// The number of a state.
inline std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31);
}

/// 0 to 1, without 1, from the upper bits.
inline double unit_part(std::uint64_t bits) {
  return static_cast<double>(bits >> 40) / static_cast<double>(1U << 24);
}

}  // namespace toile
