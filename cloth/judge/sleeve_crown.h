// Whether a sleeve is set in with its crown at the shoulder.
#pragma once

#include <vector>

#include "cloth/judge/openings.h"

namespace toile {

/// Whether a sleeve is set in upside down. Along its seam with the trunk, what lies farthest from
/// the line of the cuff is the crown. It belongs above what lies nearest, the underarm. `sleeve`
/// and `trunk` are panels. `openings` are the garment's, and `arm` is what passes through the
/// cuff's. O(n log n) in the panels' triangles.
bool is_set_in_upside_down(const PanelMesh& garment, const DressedGarment& dressed,
                           const std::vector<int>& sleeve, const std::vector<int>& trunk,
                           const std::vector<const Opening*>& openings, const LimbsThrough& arm);

}  // namespace toile
