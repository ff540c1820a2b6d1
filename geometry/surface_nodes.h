// The distances of one surface at the nodes of a regular grid, computed where they are asked for.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>

#include "geometry/body_distance.h"
#include "geometry/types.h"

namespace toile {

/// Where nodes are: node (i, j, k), each of any sign, at origin + cell (i, j, k).
struct NodeLattice {
  Vec3 origin;
  double cell;   ///< metres
  double reach;  ///< metres from the surface within which nodes hold exact distances

  /// Every so many nodes along each axis one is computed from the surface; the others between them
  /// are interpolated, unless that says that they may be near.
  static constexpr int coarsening = 4;
  /// What interpolation can be wrong by: a distance changes no faster than the point moves, and no
  /// point of a cell is farther from a corner than half its diagonal.
  double interpolation_error() const;
};

/// Signed distances at the nodes of a lattice, by bricks of 4 nodes along each axis. Each is
/// computed on first use; its values depend on surface, lattice and brick only. May be asked by
/// several threads at once.
class SurfaceNodes {
 public:
  static constexpr int side = NodeLattice::coarsening;
  /// Along x first, then y, then z.
  using Brick = std::array<float, static_cast<std::size_t>(side) * side * side>;
  using Index = std::array<int, 3>;

  SurfaceNodes(const BodyDistance& surface, const NodeLattice& lattice);
  ~SurfaceNodes();
  SurfaceNodes(const SurfaceNodes&) = delete;
  SurfaceNodes& operator=(const SurfaceNodes&) = delete;

  /// Makes room for the bricks from `first` on, `size` along each axis, among which are all those
  /// of before; what was computed stays. Not while others ask.
  void cover(const Index& first, const Index& size);

  /// The nodes from side * brick on. Costs about 64 tree queries the first time, near the skin.
  const Brick& at(const Index& brick) const;

 private:
  const Brick* compute(const Index& brick) const;
  double coarse(const Index& node) const;
  static std::size_t place(const Index& from_first, const Index& size) {
    return (static_cast<std::size_t>(from_first[2]) * size[1] + from_first[1]) * size[0] +
           from_first[0];
  }

  BodyDistance surface_;
  NodeLattice lattice_;
  Index first_ = {0, 0, 0};
  Index size_ = {0, 0, 0};
  std::unique_ptr<std::atomic<const Brick*>[]> bricks_;
  std::unique_ptr<std::atomic<float>[]> coarse_;  // one more along each axis; NaN: not known yet
};

}  // namespace toile
