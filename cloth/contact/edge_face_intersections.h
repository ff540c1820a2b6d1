// Cloth that has come through cloth, and the way back.
#pragma once

#include <array>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// An edge of the cloth that passes through one of its faces.
struct EdgeFaceIntersection {
  std::array<int, 2> edge;  ///< vertices
  Triangle face;            ///< vertices
  std::array<double, 5>
      weights;  ///< of the edge's ends, then of the face's corners, where they meet
  /// Moved this way against the face, the edge shortens the line along which two pieces of cloth
  /// intersect. It is the negative gradient of the line's length. It is short where both sides of
  /// the edge pull alike.
  Vec3 way = Vec3::Zero();
};

/// All edges of the surface that pass through its faces, in a fixed order. The exact test finds
/// them [Volino & Magnenat-Thalmann 2006, Resolving Surface Collisions through Intersection
/// Contour Minimization]. `x`: metres, one a vertex. About O(n log n) in the triangles.
std::vector<EdgeFaceIntersection> find_edge_face_intersections(
    const std::vector<Vec3>& x, const std::vector<Triangle>& triangles);

}  // namespace toile
