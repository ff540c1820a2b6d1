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
#include "cloth/start/turn_and_lift.h"

namespace toile {

struct DressResult {
  std::vector<std::pair<std::string, int>> terms;  ///< what was compiled, by term
  std::vector<Vec3> nodes;                         ///< metres; sewn points share one, see dress()
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
  /// One for each of the garment's attachments: at rest, or when it was released.
  std::vector<AttachmentMeasurement> attachments;
  std::vector<AttachedPoint> attached;  ///< what holds the garment for good
  std::vector<TightSeam> tight_seams;   ///< by the relaxation, which closes them at any tension
  /// Empty without a strain limit, and by another method than the relaxation.
  std::optional<TightRegions> tight_regions;
  /// The motion of a copy of the garment that was released. Empty: it was not. `nodes` is before.
  std::optional<ReleaseReport> release;
};

/// Dresses the scene's body with the garment, stage by stage (stages.h).
///
/// - On the coarsest of the garment's nested meshes the panels are placed (`position`). Then their
///   seams close, with the arms out of the way (`close_seams`), and what came through itself is
///   drawn back (`untangle`, sew.h). Panels that tangle are sewn again in other ways
///   (closing_attempts).
/// - The garment falls, mesh by mesh (`settle`). Each finer mesh starts from the rest of the
///   coarser one. It falls without friction, unless it would slide off.
/// - The finest mesh comes to rest with the fabric's full stiffness and friction (`rest`).
///   Attachments hold until just before that (`release_attachments`). Attachments for good go on
///   holding.
///
/// A garment that fell off is not brought to rest. Each mesh costs some four times as much as the
/// next coarser one. The same bits for any number of threads. Throws Error when the scene has no
/// body, and as find_start() and compile() do.
DressResult dress(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
                  const FrameWatcher& watcher = {});

/// A garment that went on from an earlier drape.
struct ContinuedDress {
  std::optional<DressResult> result;  ///< none: `refusal` says why it has to start from its panels
  std::string refusal;
  double outside = 0;  ///< metres: CarriedDrape's
  double seconds = 0;  ///< that it took, a refusal too
};

/// Brings a garment to rest from where an earlier drape of it lay (carry_drape.h). Only its own
/// mesh is relaxed. What crosses at first is drawn apart under its weight (untangle_worn()). Then
/// the garment comes to `rest` with friction. Attachments that hold it only while it is dressed are
/// left out. A refusal may come after a whole rest.
///
/// Refused are garments that carry_drape() refuses, and garments with attachments for good. So are
/// drapes that do not end at rest, clear of themselves and of the body. The same bits for any
/// number of threads. Throws Error as dress() does.
ContinuedDress continue_dress(const PanelMesh& garment, const Scene& scene,
                              const DressOptions& options, const DressedGarment& earlier,
                              const FrameWatcher& watcher = {});

/// The material points of a garment that is dressed, to check it as the last state.
std::vector<Vec3> material_points(const PanelMesh& garment, const DressResult& result);

}  // namespace toile
