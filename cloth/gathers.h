// Seams whose sides differ in length: which edges give way.
#pragma once

#include <map>
#include <utility>

#include "pattern/panel_mesh.h"

namespace toile {

/// Share of its flat length that each edge of material points (the lower index first) is left with
/// at rest.
using GatheredEdges = std::map<std::pair<int, int>, double>;

/// Edges on the longer side of a seam, where the two sides differ by more than 2 %. A gathered seam
/// takes the shorter side's length: the other side's fullness goes into folds beside it, not into
/// stretching its partner.
GatheredEdges gathered_edges(const PanelMesh& garment);

}  // namespace toile
