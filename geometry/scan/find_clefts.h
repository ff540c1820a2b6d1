// Finds where a scanned body has clefts: between its thighs and under its arms.
#pragma once

#include <optional>
#include <vector>

#include "geometry/axis_direction.h"
#include "geometry/scan/cleft.h"

namespace toile {

/// What a body is cut by to find its limbs.
struct RoughBody {
  TriangleMesh mesh;  ///< closed, outward-oriented; a film may be between its limbs
  AxisDirection up;
  double floor = 0;   ///< metres along `up`
  double height = 0;  ///< metres
};

/// The cleft between the thighs; nothing where there are no two legs, or where no tubes fit them.
std::optional<Cleft> leg_cleft(const RoughBody& body, const ScanSamples& samples, double least_gap);

/// Those between arms and trunk, if the body has a skeleton. Where no camera sees an armpit, its
/// height is told from the shoulder's by proportion.
std::vector<Cleft> arm_clefts(const RoughBody& body, const ScanSamples& samples, double least_gap);

}  // namespace toile
