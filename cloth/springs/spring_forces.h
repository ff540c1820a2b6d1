// What springs do to the nodes between them, and how long a step may be.
#pragma once

#include <span>
#include <vector>

#include "cloth/springs/spring.h"
#include "geometry/adjacency.h"
#include "geometry/types.h"

namespace toile {

/// Throws Error for a spring whose ends are not two nodes in [0, nodes), or whose rest length is
/// not above 0.
void check_springs(std::span<const Spring> springs, int nodes);

/// The springs laid out by node: one evaluation is one pass over flat memory.
class SpringForces {
 public:
  /// Copies the springs. Throws as check_springs().
  SpringForces(std::span<const Spring> springs, int nodes);

  /// Adds each spring's pull, N, to the forces on its ends. With d the axis from one end to the
  /// other, the pull is (stiffness·(|d| - rest) + damping·d|d|/dt) d/|d|. It is equal and opposite
  /// to the last bit at the two ends. Ends in one place get nothing. `x` in metres, `v` in m/s, one
  /// entry a node. The same bits for any number of threads.
  void add(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> force) const;

 private:
  struct Half {  ///< a spring as one of its ends sees it
    int other;
    double rest;
    double stiffness;
    double damping;
  };
  Adjacency<Half> halves_;  ///< at each node, in the order of the springs
};

/// Seconds: a step below which symplectic Euler is stable, whatever the shape. Symplectic Euler
/// takes velocities from the forces at the present positions and velocities, then positions from
/// the new velocities.
///
/// - A mode with ω² from the springs' stiffness and rate γ from their damping needs ω²dt² + 2γdt <
///   4. A drag that slows every node by `drag_rate` (1/s) adds to γ.
/// - The modes are bounded by a sum over a spring's two ends: the stiffness of all springs there
///   over the mass. The largest of the springs counts [Gershgorin's discs on the springs' own
///   matrix; for graphs Anderson & Morley 1985].
/// - The bound is exact for a long chain of equal masses, and some tenths too short for a sheet.
/// - A spring much shorter than at rest is damped no more than at rest. Compressed springs can
///   still buckle, which no step prevents.
///
/// `inverse_mass` in 1/kg, 0 where held. Infinite without springs and drag.
double stable_step(std::span<const Spring> springs, std::span<const double> inverse_mass,
                   double drag_rate = 0);

}  // namespace toile
