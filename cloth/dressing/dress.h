// Dresses a body with a garment: the stages, in their order.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cloth/dressing/dress_options.h"
#include "cloth/dressing/journal.h"
#include "cloth/judge/frame.h"
#include "cloth/judge/tight_regions.h"
#include "cloth/judge/tight_seams.h"
#include "cloth/model/garment_model.h"
#include "cloth/relaxation/relax.h"
#include "cloth/relaxation/release.h"
#include "cloth/start/draw_and_lift.h"

namespace toile {

struct DressResult {
  std::vector<std::pair<std::string, int>> terms;  ///< what was compiled, by term
  std::vector<Vec3> nodes;                         ///< metres; sewn points share one
  std::vector<Triangle> triangles;                 ///< of nodes, in the garment's order
  Placement placement;     ///< of the coarsest mesh; `initial` is of the garment's own points
  double body_offset = 0;  ///< metres kept from the skin: the scene's, more for edges above 15 mm
  std::vector<double> extra_offset;  ///< RelaxReport's; empty by the paper's method
  double time_step = 0;              ///< seconds; 0 for a method that has none
  WarmStart warm_start;              ///< where friction holds it at the end; by the relaxation only
  std::vector<StageReport> stages;
  DuringDressing during;
  Residual residual;
  bool converged = false;
  /// One for each of the garment's: at rest, or of those that end, when they were let go.
  std::vector<AttachmentFigures> attachments;
  std::vector<AttachedPoint> attached;  ///< what holds the garment for good
  std::vector<TightSeam> tight_seams;   ///< by the relaxation, which closes them at any tension
  /// Nothing: not looked for, without a strain limit or by another method than the relaxation.
  std::optional<TightRegions> tight_regions;
  /// What a copy of the garment did when it was let go; nothing: it was not. `nodes` is before.
  std::optional<ReleaseReport> release;
};

/// Dresses the scene's body with the garment, stage by stage (stages.h).
///
/// - On the coarsest of the garment's nested meshes the panels are placed (`position`), their seams
///   closed (`close_seams`), and folds let out that went through themselves (`untangle`). Panels
///   that tangle are sewn anew, twice as carefully, three times at most.
/// - The garment falls, mesh by mesh (`settle`), each finer one starting from the coarser one's
/// rest.
///   It falls without friction, unless it slides off so.
/// - The finest mesh comes to rest with the fabric's full stiffness and friction (`rest`).
///   Attachments hold until just before that (`release_attachments`), for nothing but friction may
///   hold the garment where they do. Those for good go on.
///
/// Seams that stay far open end the dressing after `close_seams`; what fell off is not brought to
/// rest. The cost of each mesh is some four times the coarser one's. The same bits for any number
/// of threads. Throws Error when the scene has no body, and what find_start() and compile() throw.
DressResult dress(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
                  const FrameWatcher& watcher = {});

/// The material points of a garment that is dressed, to check it as the last state.
std::vector<Vec3> material_points(const PanelMesh& garment, const DressResult& result);

}  // namespace toile
