// Lets go of a dressed garment, in time and with its real masses, to see whether it stays.
#pragma once

#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/force_options.h"

namespace toile {

struct ReleaseOptions : ForceOptions {
  double seconds = 1;
  /// 1/s, at which speeds decay: far below what air and cloth do to a garment.
  double damping = 1;
  double bending = 1;  ///< factor on the bending stiffness
};

struct MovedFigures {
  double median = 0;  ///< metres
  double p99 = 0;
  double max = 0;
};
/// Of the ways, metres, that each of some nodes went.
MovedFigures moved_figures(const std::vector<double>& moved);

struct ReleaseReport {
  double seconds = 0;    ///< simulated
  double time_step = 0;  ///< seconds
  int steps = 0;
  int searches = 0;  ///< for cloth near cloth
  double wall_seconds = 0;
  std::vector<double> moved;  ///< metres, per node: farthest from where it was let go
  MovedFigures all;
  int sticking = 0;  ///< nodes that friction held when they were let go, by the options' warm_start
  MovedFigures of_sticking;  ///< how far those crept
  double speed_p99 = 0;      ///< m/s, at the end
  double kinetic = 0;        ///< J, at the end
  /// Whether 99 % of the nodes stayed within 2 mm.
  bool stays() const { return all.p99 < 0.002; }
  WarmStart warm_start;        ///< where friction holds it at the end
  double released_energy = 0;  ///< J of potential energy: what became speed, and what damping took
};

/// Moves the nodes `x` (one a node, metres, at rest in the beginning) through time, under the same
/// forces as relax(), by the symplectic Euler method with a step at a safe share of the stable one.
/// Forces are taken a little ahead along the motion, which damps what is fast for the step, with a
/// rate of 0.05 step·frequency². A node that presses on other cloth harder than the step can follow
/// is given more mass for as long. Cost per step is linear in the triangles; steps per second grow
/// with the resolution. Same bits for any number of threads.
/// Throws Error when it flies apart.
ReleaseReport release(const GarmentModel& model, const ReleaseOptions& options,
                      std::vector<Vec3>& x);

}  // namespace toile
