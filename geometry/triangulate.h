// Constrained Delaunay triangulation of flat polygons.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Triangulates the inside of the simple, counter-clockwise polygon `outline` with the points
/// `interior` strictly inside it. `holes` are simple polygons strictly inside it and outside one
/// another, which stay empty. Indices count the outline's points first, then those of the holes in
/// order, then the interior ones. Triangles are counter-clockwise. Every segment of a polygon is an
/// edge, and no point is added. So there are |border| + 2 |interior| - 2 + 2 |holes| triangles.
/// Their order depends on the points alone. O(n log n).
///
/// It throws Error when a polygon is not simple, polygons meet, or points coincide or lie outside.
std::vector<Triangle> triangulate(const std::vector<Vec2>& outline,
                                  const std::vector<Vec2>& interior,
                                  const std::vector<std::vector<Vec2>>& holes = {});

/// Radians: the smallest angle of all triangles. The angles of a clockwise triangle count as
/// negative. Pi for no triangles. O(n).
double smallest_angle(const std::vector<Vec2>& points, const std::vector<Triangle>& triangles);

/// Radians: the smallest angle of a triangle, negative for a clockwise one.
double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace toile
