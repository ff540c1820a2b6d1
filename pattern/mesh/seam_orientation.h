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
/// - Seams run as the pattern states, its convention included. The others run in the direction that
///   brings the placed end points closer, as far as the garment stays two-sided. The most certain
///   seam decides first. Then panels are turned over while that shortens the sum of distances.
///   Where both directions are alike they run end to start, which is GarmentCode's rule.
/// - Right sides are chosen so that every seam joins right side to right side, and that they face
///   out of the garment as placed. Where the placement does not decide, a panel drawn
///   counter-clockwise shows its right side, which is GarmentCode's rule too.
/// - A layered stitch joins panels that face the same way.
/// - Stated seams may not all join right to right, as in a twisted band. Then the one that the
///   placement speaks against most gets a warning in `remarks`. Such a garment's right sides are
///   those of GarmentCode's rule.
///
/// O(stitches * panels) at most.
Orientation orient(const Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
