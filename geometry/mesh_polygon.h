// Fills a flat polygon with well-shaped triangles and leaves its border as it is.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Points and counter-clockwise triangles in the plane. Metres.
struct PlanarMesh {
  std::vector<Vec2> points;
  std::vector<Triangle> triangles;
};

/// Meshes the inside of the simple, counter-clockwise polygon `outline`. Edges are about
/// `edge_length` metres long, shorter toward short border segments. The outline's points come first
/// and stay as they are; no point is added on the border. Where possible, no triangle edge runs
/// across from border to border. So a corner whose two sides are sewn to those of another corner
/// still encloses cloth.
///
/// Interior points start on a hexagonal lattice. Between Delaunay triangulations they move to the
/// centres of their surroundings (centroidal patch smoothing [Chen & Holst 2011]). At last each
/// moves to where its smallest angle is largest. About O(n log n).
///
/// `holes` are simple polygons inside the outline that stay empty. Their points follow the
/// outline's, and are border like these.
///
/// `split_corners` holds indices of outline points. Each of them gets an interior point in the
/// triangle with its two neighbours on the outline, even if that makes sharp triangles. That
/// triangle has to lie inside the polygon, free of other outline points.
///
/// Throws Error as triangulate() does.
PlanarMesh mesh_polygon(const std::vector<Vec2>& outline, double edge_length,
                        const std::vector<int>& split_corners = {},
                        const std::vector<std::vector<Vec2>>& holes = {});

/// Moves points that have an angle below `good` radians to where their smallest angle is larger. It
/// keeps the triangles and the points that are `fixed`, one flag a point. No angle becomes smaller
/// than the mesh's smallest angle was. O(n) a sweep.
void raise_angles(PlanarMesh& mesh, const std::vector<bool>& fixed, double good);

}  // namespace toile
