// The distances of one surface at the nodes of a regular grid, computed where they are asked for.
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

/// Signed distances at the nodes origin + cell (i, j, k), i, j and k of any sign. Near the surface
/// they are exact; farther off they are interpolated from the nodes of a grid four times as coarse,
/// and those, where they are far, from one four times as coarse again.
/// A node is computed on first use; its value depends on surface, grid and node only. Memory is
/// used where nodes are asked for. Several threads may ask at once.
class DistanceLevels {
 public:
  using Index = std::array<int, 3>;

  /// Nodes less than `band` metres from the surface are exact.
  DistanceLevels(const SurfaceDistance& surface, const Vec3& origin, double cell, double band);

  /// Makes room for the nodes from `first` on, `size` along each axis, among which are all those of
  /// before; what was computed stays. Not while others ask.
  void cover(const Index& first, const Index& size);

  /// A tree query the first time, near the surface. The node is among those that cover() named.
  /// `near` is a point of the surface that may be near the node's, and becomes one that is.
  float at(const Index& node, SurfacePoint& near) const;

  /// What is known so far, and how many nodes of it were computed here. Not while others ask.
  DistanceCache cache() const;
  std::size_t computed_nodes() const { return computed_.load(); }
  /// Takes what another one knew of the same surface. False, and nothing is taken, when its grid
  /// was another or its numbers are none of cubes. Not while others ask.
  bool restore(const DistanceCache& cache);

  /// What a point's true distance is at least where a spline through the nodes around it says
  /// `distance`, which is more than `band`, or less than its negative.
  static double lower_bound(double distance, double cell, double band);

 private:
  /// A grid of one coarseness.
  struct Level {
    double cell;
    double exact;  // metres from the surface within which nodes are always computed from it
    double reach;  // and so are those that are said to be nearer than this
    Index first = {0, 0, 0};
    Index size = {0, 0, 0};
    struct Free {
      void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<std::atomic<float>[], Free> values;  // 0: not known yet

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
