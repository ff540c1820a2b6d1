// Distances of a surface at the nodes of its grid that were computed once, for whoever asks next.
#pragma once

#include <array>
#include <vector>

namespace toile {

/// What DistanceLevels knows, by cubes of nodes of its levels. Of use to a grid of the same
/// surface, cell, band and extent only.
struct DistanceCache {
  struct Cube {
    int number;
    std::array<float, 64> values;  ///< metres; 0: not known
  };

  double cell = 0;  ///< metres
  double band = 0;  ///< metres
  std::array<int, 3> first = {0, 0, 0};
  std::array<int, 3> size = {0, 0, 0};      ///< nodes of the finest level along each axis
  std::array<std::vector<Cube>, 3> levels;  ///< cubes by increasing numbers

  bool empty() const { return levels[0].empty() && levels[1].empty() && levels[2].empty(); }
};

}  // namespace toile
