// Dynamic relaxation: brings a compiled garment to rest without factoring a matrix.
#pragma once

#include <functional>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/relaxation/force_options.h"

namespace toile {

/// Residual force on the nodes, contact and friction included, in units of the mean node weight.
/// Nodes that press against a bound are left out: the bound holds them, as a contact would. Of
/// those that are not pressed to the body, up to max_held_share are. Of the force on a node,
/// balanced_share of the cloth's own pull is left out.
struct Residual {
  double median = 0;
  double rms = 0;  ///< root mean square
  double max = 0;
  /// Root mean square over the patches of the nested mesh's coarsest level, in units of their
  /// weights. It is the force that would set the cloth in motion as a whole. 0 without levels.
  double wide = 0;
  int held = 0;      ///< nodes that were left out
  int hardest = -1;  ///< the node of `max`; -1: there is none
};

/// Median, root mean square and maximum of the residual forces of the nodes; `wide` stays 0. Takes
/// one force a node, in units of the mean node weight, and at least one. Only `rms` is set where it
/// is not finite.
Residual residual_of(std::vector<double> forces);

struct RelaxOptions : ForceOptions {
  int max_iterations = 4000;
  /// Iterations over which seams close, or more where cloth is in the way; then the run ends. 0:
  /// seams are closed. 2000 and more keep the panels from tangling while they close [measured on
  /// two garments].
  int closing_iterations = 0;
  /// Iterations over which seams that are held apart close through cloth. 0: they stay open.
  int passing_iterations = 0;
  bool passes_body = false;  ///< whether they then close through the body, too
  /// Factors on the bending stiffness at the first iteration and at the last one (of the closing,
  /// where seams close). Far above 1, panels stay smooth and seams do not fold onto themselves.
  double bending_from = 1;
  double bending_to = 1;
  /// Iterations over which the share that resists compression grows to 1. The run does not end
  /// before. 0: the share stays.
  int stiffening_iterations = 0;
  /// Upper limit of Nesterov's weight k/(k+3). Creases creep far under next to no force, so they
  /// need most of it. With 0.995, 0.99 and 0.985, five garments at 10 mm take 1.2, 1.5 and 2.1
  /// times the node-iterations [measured].
  double momentum = 0.9995;
  double max_move = 0.004;  ///< metres that a node may move in an iteration
  /// In node weights: the garment is at rest when its residual is below both. 0: the run has all
  /// iterations.
  double stop_median = 0;
  double stop_rms = 0;
  double stop_wide = 0;  ///< unless 0, the wide residual must be below this, too
  int patience = 0;      ///< iterations without progress toward rest that end a run; 0: none do
};

/// Where the cloth stood when no seam closed any more, before they closed through what held them.
struct HeldSeams {
  std::vector<Vec3> nodes;   ///< metres; empty: all seams closed
  std::vector<double> open;  ///< per node, as RelaxReport's
};

struct RelaxReport {
  int iterations = 0;
  int searches = 0;  ///< for near cloth
  double seconds = 0;
  /// Whether the seams closed or, in a run that closes none, the garment came to rest.
  bool converged = false;
  /// Share of their width by which the seams stand open at each node; empty: they are closed.
  std::vector<double> open;
  HeldSeams held;
  Residual residual;
  WarmStart warm_start;  ///< anchors and multipliers at the end
  /// Metres, per node, that it keeps from the body beyond the model's offset. It is more than 0
  /// where one of its triangles spans something sharp.
  std::vector<double> extra_offset;
};

/// Progress of a run, for its watcher.
struct RelaxProgress {
  int iteration;
  /// Per node, of the seams' width: 1 as placed, 0 closed; empty: all are closed.
  const std::vector<double>& open;
  const std::vector<Vec3>& nodes;  ///< metres
};
using RelaxWatcher = std::function<void(const RelaxProgress&)>;

/// Moves the nodes `x` (metres, one a node) toward rest. Each iteration moves a node by its force
/// over a bound of its stiffness, with Nesterov's momentum. The momentum is cut when it runs uphill
/// [after O'Donoghue & Candes 2015]. Patches of the coarser levels move by their forces, too
/// (MultilevelPreconditioner).
///
/// The watcher is called every 50 iterations. The cost of an iteration is linear in the triangles.
/// The number of iterations grows with the square root of the ratio of stiffnesses, so about with
/// the number of nodes across. Same bits for any number of threads.
///
/// Throws Error when forces grow beyond all numbers.
RelaxReport relax(const GarmentModel& model, const RelaxOptions& options, std::vector<Vec3>& x,
                  const RelaxWatcher& watcher = {});

}  // namespace toile
