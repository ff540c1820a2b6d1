// Distances to the body at a cell's cost instead of a tree's: a grid filled where it is asked.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/distance_cache.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

struct DistanceGridOptions {
  double cell = 0.005;     ///< metres
  double band = 0.010;     ///< metres to either side of the skin within which values are exact
  double padding = 0.040;  ///< metres of grid around the body
};

/// Signed distance to the body, or to a body with sheets of cloth on it, and its gradient,
/// everywhere. Of several surfaces it is the least of their distances: where any of them says
/// inside, it is inside, so the room between skin and cloth and that below free hanging cloth
/// belong to the subject, and what comes next is pushed out through the cloth.
///  Near the skin (within `band`) the grid
/// holds exact distances; a quadratic B-spline through them gives a gradient without jumps, which
/// a solver needs to come to rest, at the price of a smoothing of about cell²/(8 R) where the body
/// curves with radius R. Farther off, values are interpolated from a coarser grid and serve only
/// to tell near from far and the way out of the body.
///
/// Nothing is computed before it is asked for: the first lookup in a block of 2 cells along each
/// axis fills it, near the skin by a query of the tree for each node that no block around it has;
/// later ones cost about 20 ns. Lookups may run in several threads at once; what they say depends
/// on the surfaces only, not on the threads or on what was asked before.
class DistanceGrid {
 public:
  explicit DistanceGrid(const SurfaceDistance& body, const DistanceGridOptions& options = {});
  /// Of one surface or more, the body first.
  explicit DistanceGrid(const std::vector<SurfaceDistance>& surfaces,
                        const DistanceGridOptions& options = {});
  ~DistanceGrid();
  DistanceGrid(DistanceGrid&&) noexcept;
  DistanceGrid& operator=(DistanceGrid&&) noexcept;

  /// One surface more. What is known of the others is kept. Not while lookups run.
  void add(const SurfaceDistance& surface);

  /// What is known of the first surface, for a grid of the same surface alone and of the same
  /// options; and how many nodes of it were computed here. Not while lookups run.
  DistanceCache cache() const;
  std::size_t computed_nodes() const;
  /// Takes what such a grid knew: lookups say the same, sooner. False, and nothing is taken, when
  /// it was another one's. To be called before the first lookup.
  bool restore(const DistanceCache& cache);

  struct Sample {
    double distance;  ///< metres, negative inside
    Vec3 gradient;    ///< of the distance: outward, about of unit length
  };

  /// Outside the grid, what its border says, continued: at least `padding` away.
  Sample at(const Vec3& point) const;

  /// What the true distance is at least, where at() said `distance`: beyond the band values are
  /// interpolated and can be too large.
  double lower_bound(double distance) const;

  /// 1/m: how much the gradient turns along a metre at most, within the band, where the nearest
  /// point changes from one side to the other.
  double gradient_bound() const { return 2 / options_.cell; }

 private:
  struct Block;
  struct Table;

  const Block* fill(int number) const;
  Sample beyond(const Vec3& point) const;

  DistanceGridOptions options_;
  Vec3 origin_;  // of the first block's first node
  double nodes_a_metre_ = 0;
  std::array<int, 3> blocks_;  // along each axis
  std::unique_ptr<Table> table_;
};

}  // namespace toile
