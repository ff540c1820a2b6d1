// The bending energy of a triangle's piece of a plate, by how it stands against its neighbours.
#pragma once

#include <array>

#include "cloth/scene/fabric.h"
#include "geometry/types.h"

namespace toile {

/// Rigidity against being rolled along a direction at `angle` (radians) to the weft, N·m:
/// (√weft cos² + √warp sin²)², an orthotropic plate's with the twisting rigidity √(warp·weft)
/// [Huber 1923; Timoshenko & Woinowsky-Krieger 1959, Theory of Plates and Shells, art. 86].
/// Fabrics' own twisting rigidity is not among what is measured.
double bending_along(const Fabric& fabric, double angle);

/// By how much the slope of a sheet jumps across the edge from `a` to `b` of a triangle (a, b, c),
/// counter-clockwise, for curvatures of 1/m along the weft, along the warp, and of twist: metres
/// each. `away` is where the corner across the edge is when unfolded: its place along the edge from
/// a, and its distance from it. The warp is at `grain` to +y. A jump is not a matter of what is
/// bent square to the edge alone, for the neighbours' corners are not opposite to each other.
Vec3 jump_by_curvature(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& away, double grain);

/// How bad three edges may be at telling curvatures apart: least eigenvalue of the Gram matrix of
/// their jumps, each scaled to length 1. They can't at all where the triangle's corners and the
/// three across its edges are on one conic. Meshes' usual triangles have 0.1 and more.
inline constexpr double min_distinct = 0.02;

/// N·m: K of the energy ½ Jᵀ K J of a triangle of `area` (m²) whose slope jumps by J across its
/// edges: that of a plate of the fabric with the curvature that the jumps tell of, in the twist
/// √(warp·weft); if edges are missing (`there`: which aren't), with the least energy of all
/// curvatures with the jumps of the others. Rows and columns of missing edges are 0; symmetric,
/// positive semidefinite. Jumps that tell too little (`min_distinct`) count as less stiff. One
/// rigidity counts as no less than 1e-4 of the other.
Eigen::Matrix3d plate_stiffness(const Fabric& fabric, double area, const std::array<Vec3, 3>& jumps,
                                const std::array<bool, 3>& there);

}  // namespace toile
