// The line along which a plane meets a worn garment, laid back onto its flat panels.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// How wide a flat panel is where a plane meets it. Metres.
struct PanelWidth {
  int panel = 0;           ///< index into DressedGarment::panels
  double flat_height = 0;  ///< mean height of the plane's line on the flat panel
  /// Cloth on the straight line at that height, as far as the plane's line covers it.
  double width = 0;
  double on_the_line = 0;  ///< length of the plane's own line on the flat panel
  /// The straight line runs through an open dart or leaves the panel: `width` is `on_the_line`.
  bool along_line = false;
};

/// A plane across the worn garment.
struct CuttingPlane {
  Vec3 origin;
  Vec3 normal;
};

/// The line of a plane on the flat panels. Metres.
struct ClothLine {
  std::vector<PanelWidth> panels;  ///< those that it crosses, in their order
  double on_the_line = 0;          ///< its own length at rest, folds and slants included
  /// The cloth across it: the sum of the panels' widths, or `on_the_line` where that is shorter by
  /// more than 1 cm. So it is where panels taper or have a crotch.
  double as_cut = 0;
};

/// The line in which the plane cuts `triangles`, indices into DressedGarment::triangles. Each panel
/// is measured at the mean flat height of the line, as far as the line covers it. So of a seam
/// across the line one side counts. The width is taken square to the grain, or along it where
/// the grain runs along the line. On the bias it is square to the axis of the drawing that the line
/// runs along the least.
///
/// `grains` are MeshedPanel::grain of each panel; empty: the warp runs along the drawing's y.
/// Linear in the garment's triangles for each panel that is cut.
ClothLine line_on_panels(const DressedGarment& garment, const std::vector<int>& triangles,
                         const CuttingPlane& plane, const std::vector<double>& grains);

/// A stretch of an open line in which a plane meets the garment, across one triangle. Metres.
struct PathStep {
  int panel = 0;
  Vec3 worn_from{0, 0, 0};
  Vec3 worn_to{0, 0, 0};
  Vec2 flat_from{0, 0};
  Vec2 flat_to{0, 0};
};
using ClothPath = std::vector<PathStep>;

/// The open lines in which a plane meets the garment, from border to border, each in order. O(n) in
/// the triangles.
std::vector<ClothPath> paths_on_plane(const DressedGarment& garment, const CuttingPlane& plane);

/// The same path from its other end.
ClothPath reversed(const ClothPath& path);

/// Metres on the flat: across each panel the straight line from where the path enters it to where
/// it leaves. So folds and bends of the path do not count.
double flat_length(const ClothPath& path);

/// An edge of the mesh on the flat.
struct FlatEdge {
  double length = 0;     ///< metres, the least of the triangles beside it
  std::set<int> panels;  ///< of the triangles beside it
};

/// The edges of the mesh by their nodes, the lower one first.
std::map<std::pair<int, int>, FlatEdge> flat_edges(const DressedGarment& garment);

/// Metres along the path as worn.
double worn_length(const ClothPath& path);

}  // namespace toile
