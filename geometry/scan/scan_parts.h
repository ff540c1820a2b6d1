// Tells the scanned body from what else is in a scan: stray points, other things, the floor.
#pragma once

#include <optional>
#include <vector>

#include "geometry/axis_direction.h"
#include "geometry/types.h"

namespace toile {

enum class ScanPart : unsigned char { body, outlier, stray, floor };

struct ScanParts {
  std::vector<ScanPart> part;  ///< one a point
  double spacing = 0;          ///< of the body's points, in their unit
  AxisDirection up;            ///< in which the body stands, as far as the points tell
  bool floor_found = false;
  bool lies = false;    ///< on a floor that tells no `up`: what was below was not seen
  double floor = 0;     ///< along `up`: of the floor, or of the body's lowest points
  double height = 0;    ///< from `floor` to the body's highest point
  double depth = 0;     ///< of its body, the lesser of its extents square to `up`
  int stray_parts = 0;  ///< things that are not the body
};

/// Sorts out the points of a scan, in any unit.
/// - Outliers: fewer points are near than 6 % of what others have.
/// - The floor: a slab at an end of the scan, wider than two soles. What has a floor stands on it;
///   that tells `up` unless it is given. Without a floor the scan stands along y, or along z where
///   it is clearly longer along z. What lies on a floor tells no `up`.
/// - Stray parts: what is more than a sixtieth of the scan's length away from the largest part.
/// `points` are finite. O(n log n).
ScanParts sort_scan(const std::vector<Vec3>& points, const std::optional<AxisDirection>& up);

}  // namespace toile
