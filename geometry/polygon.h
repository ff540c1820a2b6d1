// Closed polygons in the plane: area, crossings, points inside.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Square metres, positive when the closed polygon runs counter-clockwise. O(n).
double signed_area(const std::vector<Vec2>& outline);

/// Two segments of the closed polygon that meet; nothing when the polygon is simple. Neighbours
/// count when they fold back onto each other. Segment i runs from point i to the next. Exact
/// predicates on the given coordinates decide. About O(n log n) for outlines that do not wind much.
std::optional<std::array<int, 2>> first_crossing(const std::vector<Vec2>& outline);

/// Whether `point` lies inside the simple closed polygon, which may run in either direction. O(n).
bool inside(const std::vector<Vec2>& outline, const Vec2& point);

/// Metres from `point` to the segment from `from` to `to`.
double distance_to_segment(const Vec2& point, const Vec2& from, const Vec2& to);

}  // namespace toile
