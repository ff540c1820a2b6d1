// The smoothest function that is a signed distance where a surface was sampled.
#pragma once

#include <array>
#include <vector>

#include "geometry/scan/scan_samples.h"

namespace toile {

struct SmoothDistanceOptions {
  double spacing = 0.004;    ///< metres, of the finest grid
  double smoothing = 0.004;  ///< metres: bends within a few times this length are smoothed away
};

/// A function on a grid: negative inside, about the distance in metres near the surface.
///
/// It is the smooth signed distance of Calakli & Taubin [2011]. Among all functions it has the
/// least sum of three squares:
/// - values at the samples;
/// - slopes less normals there;
/// - second derivatives everywhere.
///
/// Because second derivatives count, a wall goes on straight where no camera saw it, and the crown
/// closes as a dome. Narrow clefts close too early all the same: a crotch up to 3 cm, an armpit up
/// to 4 cm before its end [measured]. Less weight of sharp bends, or of those outside, does not
/// help; Cleft does.
class SmoothDistance {
 public:
  /// Solves on grids from coarse to fine, on the finer ones near the surface only. Each grid starts
  /// from the coarser one and is improved by conjugate gradients [Bornemann & Deuflhard 1996]. The
  /// same bits for any number of threads. O(area / spacing^2).
  SmoothDistance(const ScanSamples& samples, const SmoothDistanceOptions& options);

  /// The value at a point: cubic between the nodes. Far outside of the box it is that of its edge.
  double operator()(const Vec3& point) const;
  const Vec3& low() const { return low_; }  ///< corners of the box where it is known
  const Vec3& high() const { return high_; }

 private:
  double spacing_ = 0;
  Vec3 origin_;
  Vec3 low_;
  Vec3 high_;
  std::array<int, 3> nodes_{};
  std::vector<float> values_;
};

}  // namespace toile
