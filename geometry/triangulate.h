// Constrained Delaunay triangulation of flat polygons.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Triangulates the inside of the simple, counter-clockwise polygon `outline` with the points
/// `interior` strictly inside it. Indices count the outline's points first, then the interior ones.
/// Triangles are counter-clockwise. Every outline segment is an edge, and no point is added. So
/// there are |outline| + 2 |interior| - 2 triangles. Their order depends on the points alone. O(n
/// log n).
///
/// It throws Error when the outline is not simple, or points coincide or lie outside.
std::vector<Triangle> triangulate(const std::vector<Vec2>& outline,
                                  const std::vector<Vec2>& interior);

/// Radians: the smallest angle of all triangles. The angles of a clockwise triangle count as
/// negative. Pi for no triangles. O(n).
double smallest_angle(const std::vector<Vec2>& points, const std::vector<Triangle>& triangles);

/// Radians: the smallest angle of a triangle, negative for a clockwise one.
double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace toile
