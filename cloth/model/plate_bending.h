// The bending energy of a triangle's piece of a plate, as a function of the jumps across its edges.
#pragma once

#include <array>

#include "cloth/scene/fabric.h"
#include "geometry/types.h"

namespace toile {

/// N·m: the rigidity against being rolled along a direction at `angle` radians to the weft. It is
/// (√weft cos² + √warp sin²)². That is an orthotropic plate's with the twisting rigidity √(warp ·
/// weft) [Huber 1923; Timoshenko & Woinowsky-Krieger 1959, Theory of Plates and Shells, art. 86].
/// The twisting rigidity of fabrics is not among the measured quantities.
double bending_along(const Fabric& fabric, double angle);

/// Metres: by how much the slope of a sheet jumps across the edge a–b of a triangle, for unit
/// curvatures (1/m). The three values are for curvature along the weft, curvature along the warp,
/// and twist.
///
/// The triangle (a, b, c) is flat and counter-clockwise, in metres. `away` is the corner across the
/// edge, unfolded: its place along the edge from a, and its distance from the edge. The warp is
/// `grain` radians from +y.
///
/// Bending square to the edge is not all that counts, for the opposite corners of the two triangles
/// are shifted along the edge.
Vec3 jump_by_curvature(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& away, double grain);

/// N·m: K of the energy ½ Jᵀ K J of a triangle of `area` m² whose slope jumps by J across its
/// edges. It is the energy of a plate of the fabric with the curvature that the jumps determine.
/// The twisting rigidity is √(warp · weft).
///
/// - `there` states which edges exist. With edges missing, it is the least energy of all curvatures
///   with the jumps of the other edges. Rows and columns of missing edges are 0.
/// - Jumps that determine the curvature badly (`min_distinct_jumps`) count as less stiff.
/// - Neither rigidity counts as less than `min_rigidity_ratio` of the other.
///
/// K is symmetric and positive semidefinite.
Eigen::Matrix3d plate_stiffness(const Fabric& fabric, double area, const std::array<Vec3, 3>& jumps,
                                const std::array<bool, 3>& there);

}  // namespace toile
