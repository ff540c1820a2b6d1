// The cotangent Laplacian of a surface, and smoothing by it.
#pragma once

#include <Eigen/SparseCore>
#include <array>

#include "geometry/types.h"

namespace toile {

/// Half the cotangents of a triangle's angles, by corner: the weight of the edge opposite to each.
/// They are bounded to [0.001, 10], for needles and obtuse corners.
std::array<double, 3> cotangent_weights(const TriangleMesh& mesh, const Triangle& triangle);

/// The cotangent Laplacian [Pinkall & Polthier 1993], positive semidefinite, a row a point. It is
/// the surface's stiffness: it has to be divided by the points' areas. O(n).
Eigen::SparseMatrix<double> cotangent_laplacian(const TriangleMesh& mesh);

/// The surface without waves that are shorter than about 2 pi `length` metres. The points move by
/// what the biharmonic energy asks [Desbrun et al. 1999, with the Laplacian squared]: of a wave of
/// that length half is left, of one three times as long 99 %. So the mesh's own edges don't matter
/// where they are shorter. About n^1.0 to n^1.5 time: 0.1 s for 24k points.
TriangleMesh smoothed(const TriangleMesh& mesh, double length);

}  // namespace toile
