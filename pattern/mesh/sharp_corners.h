// Opens corners that a curve makes too sharp to mesh.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Opens every corner that is sharper than needle_angle, where one of its edges at least is a
/// curve.
///
/// Beside the corner the curve becomes straight, over the shortest length that opens the corner to
/// opened_corner. No point of the outline moves farther than max_outline_shift: corners that would
/// need more stay as they are. Edges may overlap beside the corner, as where the curve of a neck
/// runs along the shoulder. Each opened corner adds a warning to `remarks`.
void open_sharp_corners(Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
