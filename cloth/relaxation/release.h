// Releases a dressed garment in time, with its real masses, to find whether it stays.
#pragma once

#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/constants.h"
#include "cloth/relaxation/force_options.h"

namespace toile {

struct ReleaseOptions : ForceOptions {
  double seconds = 1;  ///< simulated
  /// 1/s: the rate at which speeds decay. 1 is far below the damping by air and cloth.
  double damping = 1;
  double bending = 1;  ///< factor on the bending stiffness
};

/// Statistics of the distances (metres) that nodes have moved.
struct MoveStatistics {
  double median = 0;
  double p99 = 0;  ///< 99th percentile
  double max = 0;
};
/// Those of `moved` (metres, one a node). Linear.
MoveStatistics move_statistics(const std::vector<double>& moved);

struct ReleaseReport {
  double seconds = 0;    ///< simulated
  double time_step = 0;  ///< seconds
  int steps = 0;
  int searches = 0;  ///< for near cloth
  double wall_seconds = 0;
  std::vector<double> moved;  ///< metres, per node: its largest distance from its start
  MoveStatistics all;
  int sticking = 0;  ///< nodes with an anchor on the skin at the start, by the options' warm_start
  MoveStatistics of_sticking;  ///< distances of those nodes
  double speed_p99 = 0;        ///< m/s, at the end: 99th percentile
  double kinetic = 0;          ///< J of kinetic energy at the end
  /// Whether 99 % of the nodes stayed within 2 mm.
  bool stays() const { return all.p99 < max_stable_motion; }
  WarmStart warm_start;        ///< anchors and multipliers at the end
  double released_energy = 0;  ///< J of potential energy that became speed or that damping took
};

/// Moves the nodes `x` (metres, one a node; at rest in the beginning) through time, under the same
/// forces as relax(). It uses the symplectic Euler method, with a safe share of the longest stable
/// step.
///
/// Forces are taken a little ahead of the nodes along their motion. That damps motions that are
/// fast for the step, at a rate of 0.05 step·frequency². A node that presses on other cloth harder
/// than the step can follow is given more mass for as long.
///
/// The cost of a step is linear in the triangles. Steps per second grow with the resolution. Same
/// bits for any number of threads. Throws Error when the garment flies apart.
ReleaseReport release(const GarmentModel& model, const ReleaseOptions& options,
                      std::vector<Vec3>& x);

}  // namespace toile
