// Lets a garment at rest go, and brings it to rest anew where it does not stay.
#pragma once

#include <functional>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/release.h"

namespace toile {

/// A state, and whether it is at rest in the way that was asked for.
struct RestingState {
  std::vector<Vec3> nodes;  ///< metres, one a node
  WarmStart warm_start;     ///< where friction holds them
  bool at_rest = false;
};

/// release() of a copy of `state`, under the forces of `options` with the state's warm_start. What
/// moves off had come to rest where cloth can fall either way, as a fold can on its edge: as long
/// as it was at rest it is taken to where it has gone to, three times at most, and `come_to_rest`
/// brings it to rest from there. Returns the last release.
ReleaseReport test_stability(const GarmentModel& model, ReleaseOptions options, RestingState& state,
                             const std::function<void(RestingState&)>& come_to_rest);

}  // namespace toile
