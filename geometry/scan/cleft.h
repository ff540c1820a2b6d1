// The air between two parts of a scanned body, where cameras see little: between the thighs, or
// between an arm and the trunk.
#pragma once

#include <Eigen/Geometry>

#include "geometry/scan/limb_tube.h"

namespace toile {

struct CleftOptions {
  double least_gap = 0.01;  ///< metres of air that are left between the tubes below the roof
  double overlap = 0;       ///< metres: tubes that overlap by more have no air between them
  double lift = 0;          ///< metres by which the roof is higher than its tube; lower if negative
};

/// Two tubes, and the roof where they grow together. The roof is a tube, too: a plane between both
/// cuts the body along it, so its axis points from the one to the other.
class Cleft {
 public:
  Cleft(LimbTube one, LimbTube other, LimbTube roof, const CleftOptions& options);

  /// `distance` is a signed distance to the body's surface at `point`, and `unseen` is 1 where no
  /// camera saw it, 0 where one did. The result is the tubes' distance where they are near to each
  /// other below the roof, and goes over to `distance` around that.
  double operator()(const Vec3& point, double distance, double unseen) const;
  bool changes(const Vec3& point) const { return box_.contains(point); }

 private:
  LimbTube one_;
  LimbTube other_;
  LimbTube roof_;
  CleftOptions options_;
  Eigen::AlignedBox3d box_;  // of what is changed
};

}  // namespace toile
