// Where on the body a panel belongs, as its pattern states it: plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/body/body_part.h"
#include "geometry/types.h"

namespace toile {

/// The side of a body part that a panel stands on. Left and right are the wearer's.
enum class PlacementSide : std::uint8_t { none, front, back, left, right };

/// The direction of the flat panel that points up the body part. Up is from pelvis to neck on the
/// torso, from wrist to shoulder on an arm, and from ankle to hip on a leg.
enum class PlacementAxis : std::uint8_t { plus_y, minus_y, plus_x, minus_x };

/// How the skeleton positions a panel [Zhong & Xu 2009, figs. 1-3].
struct PanelPlacement {
  PlacementSide side = PlacementSide::none;  ///< where the panel's middle stands
  /// Share of the circumference of the body part that the panel is rolled around, up to 1. 0: it
  /// stays flat.
  double around = 0;
  PlacementAxis axis = PlacementAxis::plus_y;
  double turn_degrees = 0;       ///< degrees farther around the part; positive from front to left
  double shift = 0;              ///< metres of the panel's middle to the right, seen from outside
  std::optional<double> offset;  ///< metres: least distance from the skin; none: the default
  std::string at;                ///< name of the joint that `level` lies at; empty: the default
  std::optional<double> level;   ///< metres: upright() y at that joint; none: the panel's upper end

  /// Whether the skeleton positions the panel. If not, its translation and rotation do.
  bool by_part() const { return side != PlacementSide::none || around > 0; }

  bool operator==(const PanelPlacement&) const = default;
};

/// Turns a flat point so that the placement's axis points up. The y of the result runs up the body
/// part, its x to the right seen from outside. Metres.
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

/// The placement of the same panel once its flat coordinates are mirrored, x to -x.
inline PanelPlacement mirrored(PanelPlacement placement) {
  if (placement.axis == PlacementAxis::plus_x) {
    placement.axis = PlacementAxis::minus_x;
  } else if (placement.axis == PlacementAxis::minus_x) {
    placement.axis = PlacementAxis::plus_x;
  }
  return placement;
}

/// The side on which the panel's middle stands. If the pattern does not state it, a left limb has
/// left, a right one right, torso and head front. So a rolled panel closes at the underarm, the
/// inner leg or the middle of the back.
inline PlacementSide side_or_default(const PanelPlacement& placement, BodyPart part) {
  if (placement.side != PlacementSide::none) return placement.side;
  if (!is_limb(part)) return PlacementSide::front;
  return side_of(part) > 0 ? PlacementSide::left : PlacementSide::right;
}

/// Degrees around the body part at which the panel's middle stands: 0 in front, 90 on the wearer's
/// left.
inline double degrees_around(const PanelPlacement& placement, BodyPart part) {
  constexpr double degrees[] = {0, 0, 180, 90, -90};
  return degrees[static_cast<int>(side_or_default(placement, part))] + placement.turn_degrees;
}

}  // namespace toile
