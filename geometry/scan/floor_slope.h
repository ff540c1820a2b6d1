// How much the floor of a scan slopes: a scanner that was not level.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/axis_direction.h"
#include "geometry/types.h"

namespace toile {

struct FloorSlope {
  AxisDirection up;      ///< the axis that is nearest to the floor's upward normal
  Eigen::Matrix3d turn;  ///< brings that normal to `up`
  double degrees = 0;    ///< of the turn
};

/// The slope of the plane that most of a scan's surface lies in, if the rest is above. Nothing
/// where there is no such plane, and where it slopes by less than 0.5 or more than 40 degrees.
/// Nothing, too, where it is nearer to another axis than to `up`. Noise and outliers don't matter.
/// `points` are finite, in any unit. Its random choices have a fixed seed. O(n log n).
std::optional<FloorSlope> floor_slope(const std::vector<Vec3>& points,
                                      const std::optional<AxisDirection>& up);

}  // namespace toile
