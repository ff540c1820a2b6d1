// The air between two parts of a scanned body, where cameras see little: between the thighs, or
// between an arm and the trunk.
#pragma once

#include <Eigen/Geometry>

#include "geometry/scan/limb_tube.h"

namespace toile {

/// Two tubes, and the roof where they grow together. The roof is a tube, too: a plane between both
/// cuts the body along it, so its axis points from the one to the other.
class Cleft {
 public:
  /// `least_gap` metres of air are left between the tubes below the roof, where they overlap by
  /// less than a centimetre.
  Cleft(LimbTube one, LimbTube other, LimbTube roof, double least_gap, double overlap,
        double lift);

  /// `distance` is a signed distance to the body's surface at `point`, and `unseen` is 1 where no
  /// camera saw it, 0 where one did. The result is the tubes' distance where they are near to each
  /// other below the roof, and goes over to `distance` around that.
  double operator()(const Vec3& point, double distance, double unseen) const;
  bool changes(const Vec3& point) const { return box_.contains(point); }

 private:
  LimbTube one_;
  LimbTube other_;
  LimbTube roof_;
  double least_gap_;
  double overlap_;
  double lift_;
  Eigen::AlignedBox3d box_;  // of what is changed
};

}  // namespace toile
