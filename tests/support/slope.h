// Slopes of energies by central differences, for forces to be compared with.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/types.h"

namespace toile::test {

/// Of `energy` (of `x`, which has three coordinates an element) along each of them, with steps `h`.
template <typename Energy, typename Places>
std::vector<Vec3> slope(const Energy& energy, Places x, double h) {
  std::vector<Vec3> slope(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    for (int k = 0; k < 3; ++k) {
      const double place = x[n][k];
      x[n][k] = place + h;
      const double above = energy(x);
      x[n][k] = place - h;
      const double below = energy(x);
      x[n][k] = place;
      slope[n][k] = (above - below) / (2 * h);
    }
  }
  return slope;
}

}  // namespace toile::test
