// Girth ease: the girth of the garment around the torso less the girth of the body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/panel_widths.h"
#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The girths of body and garment at one height. Lengths in metres.
struct GirthEase {
  std::string level;   ///< "bust", "waist" or "hip"; empty for other heights
  double height = 0;   ///< above the floor
  double body = 0;     ///< girth of the convex hull of the torso's section: what a tape reads
  double garment = 0;  ///< length along the cloth, folds included
  double ease = 0;     ///< garment - body
  double as_cut = 0;   ///< sum of the panels' widths
  std::vector<PanelWidth> panels;  ///< those that the level cuts
  std::vector<int> triangles;      ///< of the garment, that the level cuts
  /// The body's girth where this cloth was drafted to lie (drafted_girths.h); none: not known.
  std::optional<double> drafted_body;
};

/// A named level at which there is no girth ease.
struct LevelLeftOut {
  std::string level;
  std::string why;
  bool is_open = false;  ///< the garment reaches it and does not close there
  double height = 0;     ///< metres above the floor; 0: the body has no such level
};

struct GirthEases {
  std::vector<GirthEase> levels;  ///< from the top down
  std::vector<LevelLeftOut> left_out;
};

/// Girth ease on horizontal planes through the torso. The planes lie at the bust, waist and hip of
/// ISO 8559-1 (girth_levels()), and every `step` metres between crotch and armpits, unless `step`
/// is 0. Levels at which the garment does not close around the torso are left out.
///
/// - As cut, each panel is measured where the level crosses it, at the mean flat height of the
///   level's line. Its width is taken square to the grain, or along it where the grain runs around
///   the body. On the bias it is square to the drawing's axis that runs down the body.
/// - Cloth that is too small stretches until it goes around. Its ease is positive, and `as_cut` is
///   less than the body's girth.
/// - A section of cloth that hangs in slanting folds is longer than the cloth is wide. So `garment`
///   of a loose garment reads up to a few per cent high; `as_cut` does not.
///
/// `grains` are MeshedPanel::grain of each panel; empty: the warp runs along the drawing's y.
/// `skeleton` has to have the joints pelvis, waist and chest. Costs one pass over both meshes per
/// level; bust, waist and hip cost about 100 passes over the body.
GirthEases measure_girth_ease(const DressedGarment& garment, const TriangleMesh& body,
                              const Skeleton& skeleton, const std::vector<double>& grains = {},
                              double step = 0.05);

}  // namespace toile
