// Constrained Delaunay triangulation of flat polygons.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Triangulates the inside of the simple, counter-clockwise polygon `outline` with the points
/// `interior` strictly inside it. Indices count the outline first, then the interior points;
/// triangles are counter-clockwise. Every outline segment is an edge and no point is added, so
/// there are |outline| + 2 |interior| - 2 triangles, in an order that depends on the points alone.
/// O(n log n). Throws Error when the outline is not simple, points coincide or lie outside.
std::vector<Triangle> triangulate(const std::vector<Vec2>& outline,
                                  const std::vector<Vec2>& interior);

/// The smallest angle of all triangles, radians; negative when a triangle is turned over (its
/// smallest angle taken negative). Pi when there are none.
double smallest_angle(const std::vector<Vec2>& points, const std::vector<Triangle>& triangles);

/// Smallest angle of one triangle, as above.
double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace toile
