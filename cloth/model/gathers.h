// Gathered seams and elastics: which mesh edges give way.
#pragma once

#include <map>
#include <utility>

#include "pattern/panel_mesh.h"

namespace toile {

/// Rest length over flat length, by edge. An edge is a pair of material points, the lower index
/// first.
using GatheredEdges = std::map<std::pair<int, int>, double>;

/// Edges on the longer side of a seam where its sides differ by more than `gather_threshold`. Such
/// an edge takes the length of the edge on the shorter side. So the fullness goes into folds beside
/// the seam, and does not stretch the shorter side.
GatheredEdges gathered_edges(const PanelMesh& garment);

/// Edges along the garment's elastics, and the edges sewn to those. The rest length of an edge is
/// that of its elastic, which draws the cloth up.
GatheredEdges elastic_edges(const PanelMesh& garment);

/// The row of triangles that touch gathered edges. Keys are triangles, values the direction of the
/// seam there, a unit vector of the flat panel.
///
/// Cloth that its thread draws up lies in folds of a few millimetres, finer than the mesh. Within
/// the depth of this row they open into folds that the mesh can have. So the row gives way in shear
/// and, off the seam, along it: it has `gathered_stiffness` times the fabric's stiffness.
std::map<int, Vec2> gathered_rows(const PanelMesh& garment, const GatheredEdges& gathered);

}  // namespace toile
