// The stages that bring a garment onto a body: position, wrap, sew, drape.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/frame.h"
#include "cloth/judge/tight_regions.h"
#include "cloth/judge/tight_seams.h"
#include "cloth/model/garment_model.h"
#include "cloth/relaxation/relax.h"
#include "cloth/relaxation/release.h"
#include "cloth/start/draw_and_lift.h"

namespace toile {

struct DressOptions {
  double stop_median = 0.0015;  ///< residual of a garment at rest, in mean node weights
  double stop_rms = 0.015;
  /// And of whole patches of cloth, in their weights, 0: not asked for. Soft motions are slow to
  /// come to rest: at 0.0015 nodes are up to 0.3 mm (rms) from where they end, at 0.003 up to 0.6
  /// mm; at 0.0007 99 % of a garment move less than 2 mm when let go for a second [measured].
  double stop_wide = 0.0015;
  int max_iterations = 40000;  ///< of the last stage, on the garment's own mesh
  double release_seconds = 0;  ///< for which the dressed garment is let go, to see if it stays
};

struct StageReport {
  std::string name;
  int attempt = 1;   ///< panels that tangle are placed and sewn anew
  double open = 0;   ///< of a wrap: what is left of the seams' offset, 0 for closed
  int vertices = 0;  ///< nodes of the mesh that the stage ran on
  int steps = 0;
  int searches = 0;
  double seconds = 0;
  double simulated = 0;  ///< seconds of the cloth's own time; 0 for a method that has none
  bool converged = false;
  Residual residual;
};

/// Of a run of relax() over that many nodes.
StageReport stage_of(const std::string& name, int vertices, const RelaxReport& report);

/// Makes a run go on until the rest that is asked for, or until it comes no nearer to it.
void ask_for_rest(const DressOptions& wanted, RelaxOptions& options);

/// What a garment went through on its way: largest changes of any panel, in percent.
struct DuringDressing {
  double area_percent = 0;
  double perimeter_percent = 0;
};

struct DressResult {
  std::vector<std::pair<std::string, int>> terms;  ///< what was compiled, by term
  std::vector<Vec3> nodes;                         ///< metres; sewn points share one
  std::vector<Triangle> triangles;                 ///< of nodes, in the garment's order
  Placement placement;
  double body_offset = 0;    ///< metres kept from the skin: the scene's, more for edges above 15 mm
  std::vector<double> lift;  ///< RelaxReport's; empty by the paper's method
  double time_step = 0;      ///< seconds; 0 for a method that has none
  WarmStart warm_start;      ///< where friction holds it at the end; by the relaxation only
  std::vector<StageReport> stages;
  DuringDressing during;
  Residual residual;
  bool converged = false;
  /// One for each of the garment's: at rest, or of those that end, when they were let go.
  std::vector<AttachmentFigures> attachments;
  std::vector<AttachedPoint> held;     ///< what holds the garment for good
  std::vector<TightSeam> tight_seams;  ///< by the relaxation, which closes them at any tension
  /// Nothing: not looked for, without a strain limit or by another method than the relaxation.
  std::optional<TightRegions> tight_regions;
  /// What a copy of the garment did when it was let go; nothing: it was not. `nodes` is before.
  std::optional<ReleaseReport> release;
};

/// Dresses the scene's body with the garment. On the coarsest of the garment's nested meshes the
/// panels are placed and their seams closed, without gravity or friction (wrap), and settle as one
/// cloth (sew); then it falls, giving way to compression, and without friction unless it slides off
/// so, mesh by mesh, each finer one starting from the coarser one's rest; at last the finest comes
/// to rest with the fabric's full stiffness and friction (drape). Attachments hold until then,
/// since nothing but friction may hold the garment where they do; those that are for good go on.
/// Throws Error when the scene has no body.
DressResult dress(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
                  const FrameWatcher& watcher = {});

/// The material points of a garment that is dressed, to check it as the last state.
std::vector<Vec3> material_points(const PanelMesh& garment, const DressResult& result);

}  // namespace toile
