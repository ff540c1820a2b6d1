// Puts numbered panels of one shape into the order of their numbers.
#pragma once

#include <vector>

#include "pattern/seams/panel_exchange.h"

namespace toile {

/// Lets panels change places that coincide and whose names differ in the number alone. The garment
/// is the same cloth, and its numbers run from left to right as seen from outside. Where such
/// panels are sewn to each other, numbers run around the garment, from the wearer's right side of
/// the front on. Others are in the order of the edges that they are sewn to, as drawn from left to
/// right. The front comes before the back, the right half before the left.
void number_panels(const Pattern& pattern, const std::vector<WalkedEdge>& edges,
                   const std::vector<PanelFit>& fits, const std::vector<PanelWords>& words,
                   std::vector<EdgeSeam>& seams);

}  // namespace toile
