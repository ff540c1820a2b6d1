// Points of outlines that stand out, as landmarks do.
#pragma once

#include <optional>
#include <vector>

#include "geometry/slice.h"
#include "geometry/types.h"

namespace toile {

/// The point that lies farthest in a direction. `points` are not empty.
Vec3 farthest(const std::vector<Vec3>& points, const Vec3& direction);

/// Where a ray in the section's plane leaves the section. It moves less under noise than the point
/// that lies farthest.
Vec3 on_ray(const Section& section, const Vec3& from, const Vec3& direction, const Vec3& normal);

/// The point of an outline in a plane of constant x that lies farthest, by a parabola through those
/// within `reach` metres.
Vec3 corner_of(const std::vector<Vec3>& outline, const Vec3& direction, double reach);

/// Metres in x.
double width_of(const Section& section);

/// Where a curve lies farthest on the side `toward` of the straight line between its ends. Points
/// within `reach`, a share of the curve's span, count by their distance, so that noise and coarse
/// edges move it little. Nothing where it lies farthest at an end.
std::optional<Vec3> bulge(const std::vector<Vec3>& curve, const Vec3& toward, double reach);

/// Where a level section's front (side 1) or back (-1) is at x.
std::optional<Vec3> at_x(const Section& section, double x, double side);

}  // namespace toile
