// Where on the body a panel belongs, as its pattern says it: plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/types.h"

namespace toile {

/// The side of a body part that a panel stands on; left and right are the wearer's.
enum class PlacementSide : std::uint8_t { none, front, back, left, right };

/// The direction of the flat panel that points up the body part: from pelvis to neck on the torso,
/// from wrist to shoulder on an arm, from ankle to hip on a leg.
enum class PlacementAxis : std::uint8_t { plus_y, minus_y, plus_x, minus_x };

/// How a panel is to be positioned by the skeleton [Zhong & Xu 2009, figs. 1-3]. Metres.
struct PanelPlacement {
  PlacementSide side = PlacementSide::none;  ///< where the panel's middle stands
  /// Share of the way around the body part that the panel is rolled to, up to 1; 0: it stays flat.
  double around = 0;
  PlacementAxis axis = PlacementAxis::plus_y;
  double turn_degrees = 0;       ///< farther around the part, as from front to left
  double shift = 0;              ///< of the middle, to the right seen from outside
  std::optional<double> offset;  ///< least distance from the skin; none: the default
  std::string at;                ///< name of the joint that `level` lies at; empty: the default
  std::optional<double> level;   ///< upright() coordinate there; none: the panel's upper end

  /// Whether the skeleton positions the panel; else its translation and rotation do.
  bool by_part() const { return side != PlacementSide::none || around > 0; }

  bool operator==(const PanelPlacement&) const = default;
};

/// A flat point with the placement's axis turned to point up: the y of what is returned runs up the
/// body part, its x to the right seen from outside.
inline Vec2 upright(PlacementAxis axis, const Vec2& flat) {
  switch (axis) {
    case PlacementAxis::plus_y:
      return flat;
    case PlacementAxis::minus_y:
      return -flat;
    case PlacementAxis::plus_x:
      return {-flat.y(), flat.x()};
    case PlacementAxis::minus_x:
      return {flat.y(), -flat.x()};
  }
  return flat;
}

/// The same placement of a panel whose flat coordinates are mirrored, x to -x.
inline PanelPlacement mirrored(PanelPlacement placement) {
  if (placement.axis == PlacementAxis::plus_x) {
    placement.axis = PlacementAxis::minus_x;
  } else if (placement.axis == PlacementAxis::minus_x) {
    placement.axis = PlacementAxis::plus_x;
  }
  return placement;
}

/// The side of `part` (one of body_parts) on which a panel's middle stands when its pattern does
/// not say: a rolled panel closes at the underarm, the inner leg, or the middle of the back.
inline PlacementSide side_or_default(const PanelPlacement& placement, const std::string& part) {
  if (placement.side != PlacementSide::none) return placement.side;
  if (part.starts_with("left_")) return PlacementSide::left;
  return part.starts_with("right_") ? PlacementSide::right : PlacementSide::front;
}

/// Degrees around a body part that the placement stands at: 0 in front, 90 on the wearer's left.
inline double degrees_around(const PanelPlacement& placement, const std::string& part) {
  constexpr double degrees[] = {0, 0, 180, 90, -90};
  return degrees[static_cast<int>(side_or_default(placement, part))] + placement.turn_degrees;
}

}  // namespace toile
