// The direction in which seams are sewn, and the face of each panel that is the cloth's right side.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

struct Orientation {
  std::vector<bool> reversed;  ///< per stitch: the start of edge a meets the end of edge b
  std::vector<bool> mirrored;  ///< per panel: the right side is the back of the drawing
};

/// Finds in which direction seams are sewn and which face of each panel is the right side.
///
/// - Seams run as the pattern states. Else they run in the direction that brings the placed end
///   points closer in sum. When both are alike they run end to start, which is GarmentCode's rule.
/// - Right sides are chosen so that every seam joins right side to right side, and that they face
///   out of the garment as placed. Where the placement does not decide, a panel drawn
///   counter-clockwise shows its right side, which is GarmentCode's rule too.
/// - Seams that cannot all join right to right, as in a twisted band, fall back to GarmentCode's
///   rule and add a warning to `remarks`.
Orientation orient(const Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
