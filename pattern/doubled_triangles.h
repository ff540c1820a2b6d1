// Triangles that sewing would lay one upon another.
#pragma once

#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// Triangles, by index and sorted, that share all three nodes with another one once all seams are
/// sewn: two corners whose sides are sewn to each other, with no point between. Such a pair
/// encloses nothing and no surface runs through it. O(n log n).
std::vector<int> doubled_triangles(const PanelMesh& garment);

}  // namespace toile
