// Closed polygons in the plane: area, crossings, what is inside.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Positive when the closed polygon runs counter-clockwise. Square metres.
double signed_area(const std::vector<Vec2>& outline);

/// Two segments of the closed polygon that meet other than by following one another, or that follow
/// one another and fold back; nothing when the polygon is simple. Segment i runs from point i to
/// the next. Decided with exact predicates on the coordinates as given. About O(n log n) for
/// outlines that do not wind much.
std::optional<std::array<int, 2>> first_crossing(const std::vector<Vec2>& outline);

/// Whether `point` lies inside the simple closed polygon (either direction). O(n).
bool inside(const std::vector<Vec2>& outline, const Vec2& point);

/// Distance from `point` to the segment from `from` to `to`.
double distance_to_segment(const Vec2& point, const Vec2& from, const Vec2& to);

}  // namespace toile
