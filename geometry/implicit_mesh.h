// The zero level of a function as a triangle mesh.
#pragma once

#include <functional>

#include "geometry/types.h"

namespace toile {

/// Negative inside, positive outside, twice differentiable near zero and about a distance there, in
/// metres. Called from several threads at once.
using ImplicitFunction = std::function<double(const Vec3&)>;

/// What is meshed, and how finely.
struct ImplicitMeshOptions {
  Vec3 low = Vec3::Constant(-1);  ///< the box that holds the surface, metres
  Vec3 high = Vec3::Constant(1);
  double spacing = 0.01;  ///< metres; of the sampling grid. Mean edges come out at 0.9 of it
  int smoothing = 12;     ///< rounds of evening out the triangles, on the surface
};

/// Meshes the surface where `shape` is zero: surface nets [Gibson 1998], made manifold [Schaefer,
/// Ju & Warren 2007], on a grid, evened out and put onto the surface by Newton's method to 1e-9 m.
/// Closed and outward-oriented; throws Error when the surface leaves the box or the spacing is too
/// coarse to tell its parts apart. O(volume / spacing^3). The same bits for any number of threads.
/// (CGAL's own surface mesher is not used: its result hangs on where its triangulation lies in
/// memory.)
TriangleMesh mesh_implicit(const ImplicitFunction& shape, const ImplicitMeshOptions& options);

}  // namespace toile
