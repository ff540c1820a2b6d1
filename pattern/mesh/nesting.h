// Whether a triangulation is nested as PanelMesh states.
#pragma once

#include <optional>
#include <string>

#include "pattern/panel_mesh.h"

namespace toile {

/// The first contradiction to what PanelMesh states for `garment.subdivisions`; none: it holds.
/// Contradictions are triangles that do not split in runs of four, edges with two middles, and
/// finer points before coarser ones. So are seams, elastics or attachments whose coarse points are
/// not every second one. Expects the panels' ranges to be in order. O(n log n).
std::optional<std::string> nesting_problem(const PanelMesh& garment);

}  // namespace toile
