// Which way round seams are sewn, and which face of each panel is the cloth's right side.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

struct Orientation {
  std::vector<bool> reversed;  ///< per stitch: the start of edge a meets the end of edge b
  std::vector<bool> mirrored;  ///< per panel: the right side is the back of the drawing
};

/// Seams: as the pattern states, else whichever way brings the placed end points closer in sum; end
/// to start, GarmentCode's rule, when both are alike. Panels: right sides are chosen so that every
/// seam joins right side to right side, facing out of the garment as placed; where the placement
/// does not tell, a panel drawn counter-clockwise shows its right side, GarmentCode's rule again.
/// Seams that cannot all join right to right (a twisted band) leave that rule alone and a remark.
Orientation orient(const Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
