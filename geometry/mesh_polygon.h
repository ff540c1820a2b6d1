// Fills a flat polygon with well-shaped triangles without touching its border.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Points and counter-clockwise triangles in the plane. Metres.
struct PlanarMesh {
  std::vector<Vec2> points;
  std::vector<Triangle> triangles;
};

/// Meshes the inside of the simple, counter-clockwise polygon `outline` with edges of about
/// `edge_length` (metres), shorter toward short border segments. The outline's points come first
/// and stay as they are; no point is added on the border. Where it can be had, no triangle edge
/// runs across from border to border, so that a corner whose two sides are sewn to those of another
/// corner still encloses cloth.
///
/// Interior points start on a hexagonal lattice and move to the centres of their surroundings
/// between Delaunay triangulations (centroidal patch smoothing, Chen & Holst 2011), then each goes
/// where its smallest angle is largest. About O(n log n).
/// `split_corners` names outline points that must get an interior point right before them even if
/// that makes sharp triangles; the triangle of such a point and its two neighbours on the outline
/// has to lie inside the polygon, free of other outline points.
/// Throws Error as triangulate() does.
PlanarMesh mesh_polygon(const std::vector<Vec2>& outline, double edge_length,
                        const std::vector<int>& split_corners = {});

/// Moves each point that is not `fixed` (one flag a point), if it has an angle below `good`
/// (radians), to where its smallest angle is larger, triangles kept. No angle of the mesh gets
/// smaller than the smallest one was. O(n) a sweep.
void raise_angles(PlanarMesh& mesh, const std::vector<bool>& fixed, double good);

}  // namespace toile
