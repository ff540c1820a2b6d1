// Dynamic relaxation: brings a compiled garment to rest without factoring a matrix.
#pragma once

#include <functional>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/force_options.h"

namespace toile {

/// Force left on the nodes, contact and friction included, as multiples of the mean node weight.
struct Residual {
  double median = 0;
  double rms = 0;
  double max = 0;
  /// Rms over the patches of the nested mesh's coarsest level, in their weights: what would set the
  /// cloth in motion as a whole. 0 without levels.
  double wide = 0;
};

struct RelaxOptions : ForceOptions {
  int max_iterations = 4000;
  /// Seams close over this many iterations or, where cloth is in the way, more; then the run ends.
  /// 0: they are closed. 2000 and more keeps the panels from tangling on their way [measured on two
  /// garments].
  int closing_iterations = 0;
  /// Factor on the bending stiffness, from the first iteration to the last (of the closing, where
  /// seams close). Far above 1, panels stay smooth and seams don't fold onto themselves.
  double bending_from = 1;
  double bending_to = 1;
  /// Over so many iterations the share that resists compression grows to 1, and the run does not
  /// end before; 0: it stays.
  int stiffening_iterations = 0;
  double momentum = 0.9995;  ///< cap of Nesterov's weight k/(k+3)
  double max_move = 0.004;   ///< metres a node may move in an iteration
  double stop_median = 0;    ///< at rest when the residual is below both, in node weights;
  double stop_rms = 0;       ///< 0: run all iterations
  double stop_wide = 0;      ///< and, unless 0, the wide one below this
  int patience = 0;          ///< iterations without coming nearer to rest that end a run; 0: never
};

struct RelaxReport {
  int iterations = 0;
  int searches = 0;  ///< for cloth near cloth
  double seconds = 0;
  /// Stopped because the seams had closed, or else by the residual; not by the count.
  bool converged = false;
  double open = 0;  ///< of seams that were to close: what is left, 0 for closed
  Residual residual;
  WarmStart warm_start;  ///< where friction holds the garment at the end
  /// Metres, per node, that it is held off the body beyond the options' offset, because a triangle
  /// of its own spans something sharp.
  std::vector<double> extra_offset;
};

/// Where a run stands, for those who watch it.
struct RelaxProgress {
  int iteration;
  double open;  ///< 1: seams as placed, 0: closed
  const std::vector<Vec3>& nodes;
};
using RelaxWatcher = std::function<void(const RelaxProgress&)>;

/// Moves the nodes `x` (one a node, metres) toward rest: each is stepped by its force over a bound
/// of its stiffness, with Nesterov's momentum, cut when it runs uphill [after O'Donoghue & Candes
/// 2015]; patches of the coarser levels likewise (MultilevelPreconditioner). The watcher is called
/// every 50 iterations. Cost per iteration is linear in the triangles; the number of iterations
/// grows with the square root of the stiffness ratios, so about with the number of nodes across.
/// Same bits for any number of threads.
RelaxReport relax(const GarmentModel& model, const RelaxOptions& options, std::vector<Vec3>& x,
                  const RelaxWatcher& watcher = {});

}  // namespace toile
