// Hands with the gaps between their fingers filled, for cloth that has to pass over them.
#pragma once

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// The body with each hand replaced by its convex hull. A cuff that closes around a hand would else
/// close between its fingers, which are thinner than the cloth's edges are long.
///
/// A hand is what lies beyond the wrist, in the direction of the lower arm. It stays as it is where
/// its hull is hardly larger, as that of a mitten. So it does where the skeleton has no wrist, or
/// where the body crosses itself at the hand. `body`: metres, closed. The result is closed and
/// contains the body. About O(n log n).
TriangleMesh with_hands_closed(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
