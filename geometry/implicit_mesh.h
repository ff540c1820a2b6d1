// The surface where a function is zero as a triangle mesh.
#pragma once

#include <functional>

#include "geometry/types.h"

namespace toile {

/// About the signed distance to the surface, metres: negative inside, positive outside. It has to
/// be twice differentiable near zero. Several threads call it at once.
using ImplicitFunction = std::function<double(const Vec3&)>;

struct ImplicitMeshOptions {
  Vec3 low = Vec3::Constant(-1);  ///< metres, lower corner of a box that holds the surface
  Vec3 high = Vec3::Constant(1);  ///< metres, upper corner
  double spacing = 0.01;  ///< metres, of the sampling grid; the mean edge is about 0.9 of it
  int smoothing = 12;     ///< rounds of evening out the triangles on the surface
  /// Points are evened out along the surface or inward, so that the ends of narrow clefts stay.
  /// Without it they are drawn out of these by a spacing or so.
  bool keeps_clefts = false;
};

/// Meshes the surface where `shape` is zero, by surface nets on a grid [Gibson 1998] that are made
/// manifold [Schaefer, Ju & Warren 2007]. The points are evened out and put onto the surface by
/// Newton's method to 1e-9 m. The mesh is closed and outward-oriented, the same bits for any number
/// of threads. It throws Error when the surface leaves the box, or when the spacing is too coarse
/// to separate its parts. O(volume / spacing^3).
///
/// It does not use CGAL's surface mesher, whose result depends on memory addresses.
TriangleMesh mesh_implicit(const ImplicitFunction& shape, const ImplicitMeshOptions& options);

}  // namespace toile
