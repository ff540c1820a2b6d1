// The parts of a body that cloth goes around: plain data.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace toile {

/// Left and right are the wearer's. `none`: not known, or not stated.
enum class BodyPart : std::uint8_t { none, torso, head, left_arm, right_arm, left_leg, right_leg };

/// The names of all but `none`, in their order.
inline constexpr std::array<std::string_view, 6> body_parts = {
    "torso", "head", "left_arm", "right_arm", "left_leg", "right_leg"};

/// One of body_parts; empty: none.
inline std::string name_of(BodyPart part) {
  return part == BodyPart::none ? "" : std::string(body_parts[static_cast<std::size_t>(part) - 1]);
}

/// The part of that name; `none` for all names but body_parts.
inline BodyPart body_part(std::string_view name) {
  const auto* const found = std::ranges::find(body_parts, name);
  return found == body_parts.end() ? BodyPart::none
                                   : static_cast<BodyPart>(found - body_parts.begin() + 1);
}

constexpr bool is_arm(BodyPart part) {
  return part == BodyPart::left_arm || part == BodyPart::right_arm;
}
constexpr bool is_leg(BodyPart part) {
  return part == BodyPart::left_leg || part == BodyPart::right_leg;
}
constexpr bool is_limb(BodyPart part) { return is_arm(part) || is_leg(part); }

constexpr BodyPart arm_of(bool left) { return left ? BodyPart::left_arm : BodyPart::right_arm; }
constexpr BodyPart leg_of(bool left) { return left ? BodyPart::left_leg : BodyPart::right_leg; }

/// +1: a limb of the wearer's left, -1: of the right, 0: no limb.
constexpr int side_of(BodyPart part) {
  if (!is_limb(part)) return 0;
  return part == BodyPart::left_arm || part == BodyPart::left_leg ? 1 : -1;
}

}  // namespace toile
