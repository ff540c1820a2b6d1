// Signed distances to one surface at the nodes of three nested grids, computed on first use.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/distance_cache.h"
#include "geometry/node_values.h"
#include "geometry/surface_distance.h"
#include "geometry/types.h"

namespace toile {

/// Signed distances at the nodes origin + cell (i, j, k), with i, j and k of any sign. A level is a
/// grid: level 0 is the finest, each next one is four times as coarse. Distances near the surface
/// are exact. Distances farther off are interpolated from the next coarser level.
///
/// A node is computed on first use. Its value depends on surface, grid and node only. Only the
/// pages of nodes in use take memory. Several threads may call compute_cube() at once.
class DistanceLevels {
 public:
  using Index = NodeValues::Index;

  /// `cell` is in metres, of level 0. Nodes less than `band` metres from the surface are exact.
  DistanceLevels(const SurfaceDistance& surface, const Vec3& origin, double cell, double band);

  /// Makes room for the nodes from `first` on, `size` along each axis. They have to include all
  /// nodes covered before. Computed distances stay. No other call may run meanwhile.
  void cover(const Index& first, const Index& size);

  /// Computes the distances at the cube of 4 x 4 x 4 nodes of the finest level that `node` belongs
  /// to. cover() has to have named it. Near the surface it costs some queries of the tree.
  void compute_cube(const Index& node) const;
  /// Metres, at the nodes of the finest level; 0: not computed.
  const NodeValues& nodes() const { return levels_[0].nodes; }

  /// The distances computed so far. No other call may run meanwhile.
  DistanceCache cache() const;
  /// Number of nodes that this object computed, without restored ones.
  std::size_t computed_nodes() const { return computed_.load(); }
  /// Takes the distances that another object computed for the same surface. Each cube of them comes
  /// into the grid on first use. It returns false and takes nothing when the cache's grid differs
  /// or a cube's number is out of range. No other call may run meanwhile.
  bool restore(DistanceCache cache);
  /// Number of nodes in the cubes that restore() took.
  std::size_t restored_nodes() const;

  /// Metres: a lower bound of a point's true distance where a spline through the nodes around it
  /// has the value `distance`. `distance` is above `band` or below -`band`.
  static double lower_bound(double distance, double cell, double band);

 private:
  /// A grid of one coarseness.
  struct Level {
    double cell;   // metres
    double exact;  // metres from the surface within which nodes are always computed exactly
    double reach;  // metres: nodes interpolated to be nearer than this are computed exactly, too
    mutable NodeValues nodes;                // metres
    std::vector<DistanceCache::Cube> known;  // restored
    std::vector<int> known_at;         // per cube, its place in `known`, from 1; 0: it is not there
    mutable std::vector<char> in_use;  // per cube, whether `nodes` has some of it, or all known

    std::size_t cubes() const;
    std::size_t cube_of(const Index& node) const;
    /// Calls with i and the place of each node i of a cube.
    template <typename Call>
    void for_each_node(std::size_t cube, const Call& call) const;
    /// Whether a cube is in use. What is known of it has come into `nodes` then.
    bool uses(std::size_t cube) const;
    void use(std::size_t cube) const;
  };
  static constexpr std::size_t levels = 3;

  using Corners = std::array<double, 8>;

  /// The distance at a node of a coarser level. `near` is a hint, a point of the surface. A query
  /// sets it to the node's closest point.
  float at(std::size_t level, const Index& node, SurfacePoint& near) const;
  /// The distances at the corners of a cell of a coarser level.
  Corners corners(std::size_t level, const Index& cell, SurfacePoint& near) const;
  /// The distance at a node that the next coarser level's cell around it gives; none where it has
  /// to be exact.
  std::optional<float> interpolated(std::size_t level, const Index& node,
                                    const Corners& corners) const;
  Vec3 point(std::size_t level, const Index& node) const;
  void store(std::size_t level, std::size_t place, float value) const;

  SurfaceDistance surface_;
  Vec3 origin_;
  double band_;
  mutable std::atomic<std::size_t> computed_ = 0;
  std::array<Level, levels> levels_;
};

}  // namespace toile
