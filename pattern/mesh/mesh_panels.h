// From a pattern to triangulated panels whose seam sides carry equal numbers of points.
#pragma once

#include <string>
#include <vector>

#include "pattern/panel_mesh.h"
#include "pattern/pattern.h"

namespace toile {

/// How fine panels are meshed.
struct MeshSettings {
  double edge_length = 0.01;  ///< wanted length of triangle edges, metres
  /// Subdivisions of the nested triangulation, 0 to max_subdivisions. A negative number asks for as
  /// many as keep the coarsest edges at about coarsest_edge. A coarsest level of more than
  /// many_coarsest_triangles gets one more, if its edges stay below longest_coarse_edge. One of
  /// more than max_coarsest_triangles gets as many as it needs.
  int subdivisions = -1;
};

/// Meshes every panel of a checked pattern.
///
/// - Each outline edge is cut into equal steps of its length on the coarsest level. The longer side
///   of a seam decides the number of steps for both. No border points are added after that.
/// - Border points lie on the outline's curves on every level.
/// - Flat coordinates show the panel's right side. A panel whose right side is the back of its
///   drawing is mirrored: x to -x, and the grain too. So all triangles are counter-clockwise and,
///   once sewn, face out of the garment.
/// - A dart's two sides share the point at its tip.
///
/// Where a coarse outline would cross itself or give needles, fewer subdivisions are used and a
/// remark says so. Throws Error, naming the panel, when even the finest outline cannot be meshed.
/// Throws it when the mesh would have more than two million triangles.
PanelMesh mesh_panels(const Pattern& pattern, const MeshSettings& settings,
                      std::vector<Remark>& remarks);

}  // namespace toile
