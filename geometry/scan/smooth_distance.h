// The smoothest function that is a signed distance where a surface was sampled.
#pragma once

#include <array>
#include <vector>

#include "geometry/scan/scan_samples.h"

namespace toile {

struct SmoothDistanceOptions {
  double spacing = 0.004;    ///< metres, of the finest grid
  double smoothing = 0.004;  ///< metres: waves shorter than 2 pi times this are smoothed away
};

/// A function on a grid: negative inside, about the distance in metres near the surface.
///
/// It is the smooth signed distance of Calakli & Taubin [2011]: among all functions the one with
/// the least sum of the squared values at the samples, of the squared differences between slopes
/// and normals there, and of the squared second derivatives everywhere. Because second derivatives
/// are what counts, a wall goes on straight where no camera saw it. So two thighs that lean to each
/// other meet where they would, and the crown closes as a dome. Poisson reconstruction [Kazhdan et
/// al. 2006] minimises first derivatives. It spans a web between the thighs at the edge of what was
/// seen.
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
