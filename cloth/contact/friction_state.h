// Anchors of friction: the points at which cloth sticks to the body and to cloth.
#pragma once

#include <array>

#include "geometry/types.h"

namespace toile {

/// An edge whose middle sticks to the body.
struct EdgeAnchor {
  std::array<int, 2> edge;  ///< indices of its vertices, the lower one first
  Vec3 position;            ///< metres: the point on the body that its middle sticks to
};

/// Two points, one on each side of a pair, that stick to each other.
struct PairAnchor {
  std::array<int, 4> vertices;    ///< indices, in the order of ContactPair::vertices
  bool edges;                     ///< whether the pair is two edges, not vertex and triangle
  std::array<double, 4> weights;  ///< of the points, signed as NearestPoints::weights
  Vec3 offset;  ///< metres: first point minus second, along the cloth, where the spring is slack
};

}  // namespace toile
