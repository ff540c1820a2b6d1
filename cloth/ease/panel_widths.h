// How wide the panels of a garment are cut where a plane meets the garment as worn.
#pragma once

#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// How wide a flat panel is where a plane meets it.
struct PanelWidth {
  int panel = 0;           ///< index into DressedGarment::panels
  double flat_height = 0;  ///< metres: mean height of the plane's line on the flat panel
  double width = 0;        ///< metres of cloth on the straight line at that height
  /// The line runs along an edge of the panel, and the straight line leaves the panel on its way.
  /// Then `width` is that of the plane's own line, less its rise and fall.
  bool along_edge = false;
};

/// A plane across the worn garment.
struct CuttingPlane {
  Vec3 origin;
  Vec3 normal;
};

/// The widths of the panels that the plane cuts in `triangles`, in the order of the panels. Each is
/// measured at the mean flat height of the plane's line. The width is taken square to the grain, or
/// along it where the grain runs along the line. On the bias it is square to the axis of the
/// drawing that the line runs along the least.
///
/// `triangles` are indices into DressedGarment::triangles. `grains` are MeshedPanel::grain of each
/// panel; empty: the warp runs along the drawing's y. Linear in the garment's triangles for each
/// panel that is cut.
std::vector<PanelWidth> panel_widths(const DressedGarment& garment,
                                     const std::vector<int>& triangles, const CuttingPlane& plane,
                                     const std::vector<double>& grains);

}  // namespace toile
