// A rectangular cloth of springs on a regular grid, and a chain.
#pragma once

#include <cmath>
#include <vector>

#include "cloth/springs/spring.h"
#include "geometry/types.h"

namespace toile::test {

struct SpringGrid {
  int columns = 0;
  int rows = 0;
  std::vector<Vec3> x;  ///< node (column, row) is row·columns + column
  std::vector<Spring> structural;
  std::vector<Spring> shear;
  std::vector<Spring> bending;  ///< between second neighbours

  int node(int column, int row) const { return row * columns + column; }

  std::vector<Spring> limited() const {
    std::vector<Spring> all = structural;
    all.insert(all.end(), shear.begin(), shear.end());
    return all;
  }
  std::vector<Spring> all() const {
    std::vector<Spring> all = limited();
    all.insert(all.end(), bending.begin(), bending.end());
    return all;
  }
};

struct SpringGridOptions {
  int columns = 17;
  int rows = 17;
  double spacing = 0.0625;  ///< metres
  double structural = 50;   ///< N/m
  double shear = 50;
  double bending = 50;
  double damping = 0;  ///< N·s/m, of every spring
};

/// At rest in the x-z plane [the links of Provot 1995, 2].
inline SpringGrid spring_grid(const SpringGridOptions& options) {
  SpringGrid grid;
  grid.columns = options.columns;
  grid.rows = options.rows;
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      grid.x.push_back(options.spacing * Vec3(c, 0, r));
    }
  }
  const auto join = [&](std::vector<Spring>& springs, double stiffness, int c, int r, int c2,
                        int r2) {
    if (c2 < 0 || c2 >= grid.columns || r2 >= grid.rows) return;
    springs.push_back({grid.node(c, r), grid.node(c2, r2),
                       options.spacing * std::hypot(c2 - c, r2 - r), stiffness, options.damping});
  };
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.columns; ++c) {
      join(grid.structural, options.structural, c, r, c + 1, r);
      join(grid.structural, options.structural, c, r, c, r + 1);
      join(grid.shear, options.shear, c, r, c + 1, r + 1);
      join(grid.shear, options.shear, c, r, c - 1, r + 1);
      join(grid.bending, options.bending, c, r, c + 2, r);
      join(grid.bending, options.bending, c, r, c, r + 2);
    }
  }
  return grid;
}

/// Springs between nodes 0, 1, .. `links` in turn.
inline std::vector<Spring> spring_chain(int links, double rest, double stiffness,
                                        double damping = 0) {
  std::vector<Spring> springs;
  for (int i = 0; i < links; ++i) springs.push_back({i, i + 1, rest, stiffness, damping});
  return springs;
}

}  // namespace toile::test
