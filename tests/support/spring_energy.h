// The energy of springs, whose gradient is minus their forces without damping.
#pragma once

#include <span>

#include "cloth/springs/spring.h"
#include "geometry/types.h"

namespace toile {

/// Joules held by the springs with their nodes at `x` (metres, one entry a node).
inline double spring_energy(std::span<const Spring> springs, std::span<const Vec3> x) {
  double energy = 0;
  for (const Spring& s : springs) {
    const double change = (x[s.b] - x[s.a]).norm() - s.rest;
    energy += 0.5 * s.stiffness * change * change;
  }
  return energy;
}

}  // namespace toile
