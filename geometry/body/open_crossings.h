// Opens the creases of a skin that crosses itself by millimetres.
#pragma once

#include "geometry/types.h"

namespace toile {

struct OpenedCrossings {
  int pairs_before = 0;     ///< of triangles that cross
  int pairs_left = 0;       ///< 0: all are opened
  double largest_move = 0;  ///< metres by which a point was moved
};

/// Metres: creases that need more are left as they are. Arms that press against the chest need
/// up to 10 mm, a crotch that sits up to 20 mm. 40 mm opens no more of the creases tried.
inline constexpr double max_crease_move = 0.025;

/// Smooths the skin around the triangles that cross until none does. The smoothed part grows by a
/// ring of triangles every fourth round. Where that takes more than max_crease_move, limbs go
/// through each other: then `mesh` stays as it was. The judge is self_intersections(), once a
/// round. `mesh` is closed. The same input gives the same bits.
OpenedCrossings open_crossings(TriangleMesh& mesh);

}  // namespace toile
