// The shortest line on a surface between two points.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// The exact shortest line on the surface from the point of it nearest to `a` to that nearest to
/// `b`, by CGAL's Surface_mesh_shortest_path [Xin & Wang 2009]. The heat method is faster for many
/// ends, but errs by some millimetres on meshes of bodies. Only the surface within an ellipsoid
/// around both points is searched, which keeps the cost at some milliseconds. The ellipsoid grows
/// until the line is surely within it. `mesh` is 2-manifold. Empty where the surface does not join
/// them.
std::vector<Vec3> geodesic(const TriangleMesh& mesh, const Vec3& a, const Vec3& b);

}  // namespace toile
