// Normals at the points of a surface, for what is shown smooth.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Unit vectors, one a point: the mean of the normals of the triangles around it, by their angles
/// there [Thürmer & Wüthrich 1998]. It points to where the triangles are counter-clockwise. A point
/// without a triangle that has area gets +y.
std::vector<Vec3> vertex_normals(const std::vector<Vec3>& points,
                                 const std::vector<Triangle>& triangles);

}  // namespace toile
