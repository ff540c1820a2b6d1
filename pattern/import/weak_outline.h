// Outlines that touch themselves, and notches that are drawn as a part of the shape.
#pragma once

#include <vector>

#include "pattern/import/piece.h"

namespace toile {

/// What an outline is when it is drawn without the parts that bound no cloth.
struct PlainOutline {
  std::vector<Vec2> outline;
  std::vector<PieceNotch> notches;         ///< their angles point from the mouth to the tip
  std::vector<std::vector<Vec2>> holes;    ///< such as darts that a slit joins to the edge
  std::vector<std::vector<Vec2>> slashes;  ///< slits that are longer than a notch
};

/// The outline without what touches itself, and without notches.
///
/// - A slit is drawn there and back. Up to 15 mm long it is a notch; longer, a slash.
/// - A loop that runs the other way round than the outline is a hole, and the slit to it is closed.
/// - Loops that are thinner than 0.1 mm go: sides that cross by so much.
/// - A V or a castle notch is up to 8 mm wide at its mouth, 2 to 12 mm deep, and alike on both
///   sides. The outline goes on behind it as before.
///
/// What else crosses itself stays so. `outline` has an area that is not 0. O(n log n) of its points
/// for each touch.
PlainOutline plain_outline(std::vector<Vec2> outline);

}  // namespace toile
