// Signed distances to one surface at the nodes of three nested grids, computed on first use.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>

#include "geometry/distance_cache.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// Signed distances at the nodes origin + cell (i, j, k), with i, j and k of any sign. A level is a
/// grid: level 0 is the finest, each next one is four times as coarse. Distances near the surface
/// are exact. Distances farther off are interpolated from the next coarser level.
///
/// A node is computed on first use. Its value depends on surface, grid and node only. Only the
/// pages of nodes in use take memory. Several threads may call at() at once.
class DistanceLevels {
 public:
  using Index = std::array<int, 3>;

  /// `cell` is in metres, of level 0. Nodes less than `band` metres from the surface are exact.
  DistanceLevels(const SurfaceDistance& surface, const Vec3& origin, double cell, double band);

  /// Makes room for the nodes from `first` on, `size` along each axis. They have to include all
  /// nodes covered before. Computed distances stay. No other call may run meanwhile.
  void cover(const Index& first, const Index& size);

  /// The distance at a node that cover() named, metres. The first call for a node near the surface
  /// costs a query of the tree. `near` is a hint, a point of the surface. A query sets it to the
  /// node's closest point.
  float at(const Index& node, SurfacePoint& near) const;

  static constexpr int block_side = 4;
  /// The distances at the nodes of a block: `block_side` along each axis from `first` on, along x
  /// first, then y, then z. The same as at() of each in this order, found faster.
  void block_at(const Index& first, float* values) const;

  /// The distances computed so far. No other call may run meanwhile.
  DistanceCache cache() const;
  /// Number of nodes that this object computed, without restored ones.
  std::size_t computed_nodes() const { return computed_.load(); }
  /// Takes the distances that another object computed for the same surface. It returns false and
  /// takes nothing when the cache's grid differs or a cube's number is out of range. No other call
  /// may run meanwhile.
  bool restore(const DistanceCache& cache);

  /// Metres: a lower bound of a point's true distance where a spline through the nodes around it
  /// has the value `distance`. `distance` is above `band` or below -`band`.
  static double lower_bound(double distance, double cell, double band);

 private:
  /// A grid of one coarseness.
  struct Level {
    double cell;   // metres
    double exact;  // metres from the surface within which nodes are always computed exactly
    double reach;  // metres: nodes interpolated to be nearer than this are computed exactly, too
    Index first = {0, 0, 0};
    Index size = {0, 0, 0};
    struct Free {
      void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<std::atomic<float>[], Free> values;  // metres; 0: not computed

    std::size_t place(const Index& node) const;
    std::size_t cubes() const;
  };
  static constexpr std::size_t levels = 3;

  float at(std::size_t level, const Index& node, SurfacePoint& near) const;
  float compute(std::size_t level, const Index& node, SurfacePoint& near) const;

  SurfaceDistance surface_;
  Vec3 origin_;
  double band_;
  mutable std::atomic<std::size_t> computed_ = 0;
  std::array<Level, levels> levels_;
};

}  // namespace toile
