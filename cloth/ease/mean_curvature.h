// How sharply a surface bends.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// The mean curvature at each point, 1/m, from the cotangents of the angles around it [Meyer,
/// Desbrun, Schröder & Barr 2003, eq. 8]. Positive where the surface bulges towards the side that
/// its triangles face; half of 1/r on a cylinder of radius r. 0 at points of the border, where it
/// is not known, and at points of no triangle.
std::vector<double> mean_curvatures(const TriangleMesh& mesh);

}  // namespace toile
