// One of the six directions along the axes: plain data.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/types.h"

namespace toile {

struct AxisDirection {
  int axis = 1;  ///< 0 x, 1 y, 2 z
  int sign = 1;  ///< 1 or -1

  Vec3 vector() const { return sign * Vec3::Unit(axis); }
  /// "x", "-x", "y", ...
  std::string name() const {
    constexpr const char* names[2][3] = {{"-x", "-y", "-z"}, {"x", "y", "z"}};
    return names[sign > 0 ? 1 : 0][axis];
  }
};

/// The direction of that name; nothing for another word.
inline std::optional<AxisDirection> axis_direction(std::string_view name) {
  AxisDirection direction;
  if (!name.empty() && (name.front() == '-' || name.front() == '+')) {
    direction.sign = name.front() == '-' ? -1 : 1;
    name.remove_prefix(1);
  }
  if (name.size() != 1 || name.front() < 'x' || name.front() > 'z') return std::nullopt;
  direction.axis = name.front() - 'x';
  return direction;
}

}  // namespace toile
