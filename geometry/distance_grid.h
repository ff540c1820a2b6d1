// Signed distances to the body from a grid, which costs less than a query of a tree.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/distance_cache.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

struct DistanceGridOptions {
  double cell = 0.005;     ///< metres
  double band = 0.010;     ///< metres from the skin within which values are exact
  double padding = 0.040;  ///< metres of grid around the body
};

/// Signed distance, and its gradient, to a body or to a body with sheets of cloth on it. It is
/// defined everywhere. The distance to several surfaces is the least of their distances. A point
/// inside any of them is inside: the room between skin and cloth and the room below free hanging
/// cloth belong to the collider. The next layer is pushed out of them through the cloth.
///
/// Within `band` of the skin the grid holds exact distances. A quadratic B-spline through them has
/// a gradient without jumps, which a solver needs to come to rest. The spline smooths the distance
/// by about cell²/(8 R) where the body curves with radius R. Farther off, values are interpolated
/// from a coarser grid. They serve only to separate near from far and to point out of the body.
///
/// The first lookup in a cube of 4 x 4 x 4 nodes computes them all. Near the skin this takes some
/// 25 microseconds. Later lookups cost about 20 ns. Lookups may run in several threads at once.
/// Their results depend on the surfaces only, not on the threads or on earlier lookups.
class DistanceGrid {
 public:
  explicit DistanceGrid(const SurfaceDistance& body, const DistanceGridOptions& options = {});
  /// For one surface or more, the body first.
  explicit DistanceGrid(const std::vector<SurfaceDistance>& surfaces,
                        const DistanceGridOptions& options = {});
  ~DistanceGrid();
  DistanceGrid(DistanceGrid&&) noexcept;
  DistanceGrid& operator=(DistanceGrid&&) noexcept;

  /// Adds a surface and keeps the distances computed for the others. Lookups must not run
  /// meanwhile.
  void add(const SurfaceDistance& surface);

  /// The distances computed so far for the first surface. They fit a grid of this surface alone
  /// with the same options. Lookups must not run meanwhile.
  DistanceCache cache() const;
  /// Number of the first surface's nodes that this grid computed, without restored ones.
  std::size_t computed_nodes() const;
  /// Takes the distances that such a grid computed: lookups return the same, sooner. It returns
  /// false and takes nothing from the cache of a different grid. Call it before the first lookup.
  bool restore(DistanceCache cache);
  /// Number of nodes in what restore() took.
  std::size_t restored_nodes() const;

  struct Sample {
    double distance;  ///< metres, negative inside
    Vec3 gradient;    ///< of the distance: outward, of about unit length
  };

  /// The distance at a point, metres. Outside the grid it is continued from the grid's border, and
  /// is at least `padding`.
  Sample at(const Vec3& point) const;

  /// Metres: a lower bound of the true distance where at() returned `distance`. Values beyond the
  /// band are interpolated and can be too large.
  double lower_bound(double distance) const;

  /// 1/m: an upper bound of the gradient's change per metre within the band. It is reached where
  /// the closest point jumps from one side to the other.
  double gradient_bound() const { return 2 / options_.cell; }

 private:
  struct Table;

  Sample beyond(const Vec3& point) const;

  DistanceGridOptions options_;
  Vec3 origin_;               // metres: the first node that a lookup may be nearest to
  double nodes_a_metre_ = 0;  // 1/m
  std::array<int, 3> size_;   // the number of such nodes along each axis
  std::unique_ptr<Table> table_;
};

}  // namespace toile
