// Garments that are worn one over another, moved as one: what lies over a garment presses on it.
#pragma once

#include <optional>
#include <vector>

#include "cloth/dressing/dress.h"

namespace toile {

/// A garment that is dressed, one of several.
struct WornGarment {
  const PanelMesh* garment = nullptr;
  Fabric fabric;                             ///< of the panels that name none
  std::vector<Vec3> nodes;                   ///< metres, where it was dressed
  WarmStart warm_start;                      ///< where friction holds it
  double body_offset = 0;                    ///< metres kept from the skin
  std::vector<AttachedPoint> attached = {};  ///< what holds it for good
};

/// Panels, seams and points of all garments in one mesh, garment by garment. Seams join what they
/// joined before, so garments share no node. Attachments are left out: only the dressing knows
/// their places. Panels that name no fabric get the name `garment_fabric(i)` of garment i. The mesh
/// is nested as deep as the garment with the fewest levels.
PanelMesh join_garments(const std::vector<WornGarment>& garments);
std::string garment_fabric(std::size_t garment);

/// How two garments press on each other, by their indices, the one that was dressed first first.
struct LayerContact {
  int inner = 0;
  int outer = 0;
  double force = 0;  ///< N, sum of the pushes between them
  double area = 0;   ///< m² of the inner one's nodes that touch, to a twentieth of the gap
};

struct CoupledResult {
  /// Of the whole, one for each time it was brought to rest; residuals are all garments'.
  std::vector<StageReport> stages;
  bool converged = false;                           ///< the whole came to the rest asked for
  std::vector<std::vector<Vec3>> nodes;             ///< metres, by garment
  std::vector<std::vector<double>> extra_offset;    ///< metres, by garment: RelaxReport's
  std::vector<MoveStatistics> moved;                ///< by garment: from where it was dressed
  std::vector<std::vector<TightSeam>> tight_seams;  ///< by garment
  std::vector<TightRegions> tight_regions;          ///< by garment; none without a strain limit
  std::vector<LayerContact> contacts;               ///< of garments that touch, sorted
  std::optional<ReleaseReport> release;             ///< of the whole, if it was asked for
};

/// Brings garments to rest together on the scene's body, starting where each was dressed over the
/// ones before. Every garment moves, and garments that touch push each other.
/// The scene's body has to be bare, and nothing may intersect. Moves are bounded, so nothing comes
/// to intersect: neither cloth with cloth nor cloth with the skin. A frame's mesh is
/// join_garments().
/// Throws Error for garments that intersect each other or themselves.
CoupledResult relax_coupled(const std::vector<WornGarment>& garments, const Scene& scene,
                            const DressOptions& options, const FrameWatcher& watcher = {});

}  // namespace toile
