// Triangles that sewing would lay one upon another.
#pragma once

#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// Indices, sorted, of the triangles that share all three nodes with another triangle once all
/// seams are sewn. That happens where two corners have no inner point and both of their sides are
/// sewn to each other. Such a pair encloses nothing, and no surface runs through it. O(n log n).
std::vector<int> doubled_triangles(const PanelMesh& garment);

}  // namespace toile
