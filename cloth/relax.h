// Dynamic relaxation: brings a compiled garment to rest without factoring a matrix.
#pragma once

#include <functional>
#include <vector>

#include "cloth/program.h"

namespace toile {

/// Force left on the nodes, contact and friction included, as multiples of the mean node weight.
struct Residual {
  double median = 0;
  double rms = 0;
  double max = 0;
};

struct RelaxOptions {
  int max_iterations = 4000;
  /// Seams close over this many iterations (0: they are closed); 2000 and more keeps the panels
  /// from tangling on their way [measured on two garments].
  int closing_iterations = 0;
  /// Bending stiffness while seams start to close, fading to 1: keeps the panels smooth.
  double bending_boost = 1;
  double gravity = 1;    ///< factor on the scene's
  bool friction = true;  ///< against the body; off, a garment can find its way down
  bool self_contact = true;
  /// Keeps every node within its bound of the last search, so that what is apart stays apart.
  /// To be used from a state without intersections; a tangle would be locked in.
  bool bounded = false;
  double momentum = 0.9995;    ///< cap of Nesterov's weight k/(k+3)
  double max_move = 0.004;     ///< metres a node may move in an iteration
  double body_offset = 0.002;  ///< metres; larger on coarse meshes, whose faces cut corners
  double self_radius = 0.005;  ///< metres within which cloth is looked for
  double stop_median = 0;      ///< at rest when the residual is below both, in node weights;
  double stop_rms = 0;         ///< 0: run all iterations
};

struct RelaxReport {
  int iterations = 0;
  int searches = 0;  ///< for cloth near cloth
  double seconds = 0;
  bool converged = false;  ///< stopped by the residual, not by the count
  Residual residual;
};

/// Where a run stands, for those who watch it. `points` are the places of the material points.
struct RelaxProgress {
  int iteration;
  double open;  ///< 1: seams as placed, 0: closed
  const std::vector<Vec3>& nodes;
};
using RelaxWatcher = std::function<void(const RelaxProgress&)>;

/// Place of every material point while seams are `open`.
std::vector<Vec3> point_positions(const Program& program, const std::vector<Vec3>& nodes,
                                  double open);

/// Moves the nodes `x` (one a node, metres) toward rest: each is stepped by its force over a bound
/// of its stiffness, with Nesterov's momentum, restarted when it runs uphill [O'Donoghue & Candes
/// 2015]. The watcher is called every 50 iterations. Cost per iteration is linear in the triangles;
/// the number of iterations grows with the square root of the stiffness ratios, so about with
/// the number of nodes across. Same bits for any number of threads.
RelaxReport relax(const Program& program, const RelaxOptions& options, std::vector<Vec3>& x,
                  const RelaxWatcher& watcher = {});

}  // namespace toile
