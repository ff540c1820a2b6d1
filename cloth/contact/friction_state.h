// What friction remembers of cloth that presses on something.
#pragma once

#include <array>

#include "geometry/types.h"

namespace toile {

/// The middle of an edge that sticks to the body.
struct EdgeAnchor {
  std::array<int, 2> edge;  ///< its vertices, the lower first
  Vec3 position;            ///< metres, where it sticks
};

/// Two points of a pair, one of either side, that try to stay side by side.
struct PairAnchor {
  std::array<int, 4> vertices;    ///< as a ContactPair's
  bool edges;                     ///< likewise
  std::array<double, 4> weights;  ///< of the points: one less the other, as NearestPoints'
  Vec3 anchor;                    ///< metres along the cloth, of the one from the other, unpulled
};

}  // namespace toile
