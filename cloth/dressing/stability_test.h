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

/// Releases a copy of `state` under the forces of `options`, from its friction anchors, and returns
/// the last release.
/// Cloth that moves off was at rest where it can fall either way, as a fold can on its edge. Then
/// the state goes to where the copy went, three times at most, as long as it was at rest.
/// `come_to_rest` brings it to rest from there.
ReleaseReport test_stability(const GarmentModel& model, ReleaseOptions options, RestingState& state,
                             const std::function<void(RestingState&)>& come_to_rest);

}  // namespace toile
