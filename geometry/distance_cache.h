// Distances to a surface at the nodes of its grids, computed once and kept for later runs.
#pragma once

#include <array>
#include <vector>

namespace toile {

/// The distances that DistanceLevels has computed. It fits only DistanceLevels of the same surface,
/// cell, band and extent.
struct DistanceCache {
  /// A cube of 4 x 4 x 4 nodes of one level.
  struct Cube {
    int number;                    ///< index of the cube in its level
    std::array<float, 64> values;  ///< metres, per node; 0: not computed
  };

  double cell = 0;                          ///< metres between nodes of the finest level
  double band = 0;                          ///< metres from the surface that are exact
  std::array<int, 3> first = {0, 0, 0};     ///< first node of the finest level
  std::array<int, 3> size = {0, 0, 0};      ///< nodes of the finest level along each axis
  std::array<std::vector<Cube>, 3> levels;  ///< cubes in rising number, finest level first

  bool empty() const { return levels[0].empty() && levels[1].empty() && levels[2].empty(); }
};

}  // namespace toile
