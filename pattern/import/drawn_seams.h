// Seams that a drawing states by texts on its seam lines.
#pragma once

#include <string>
#include <vector>

#include "pattern/import/imported_pattern.h"

namespace toile {

/// The text of a seam, turned about the drawing's origin by `angle` radians, counter-clockwise.
PieceSeam turned_seam(PieceSeam drawn, double angle);

/// The edge that a text of a seam stands on, and whether the text runs along it from its start.
SeamSide seam_side(const PieceSeam& drawn, const EdgedOutline& outline);

/// The seams of which both sides are there, in the order of their numbers. A remark names numbers
/// that are not there twice, once as a and once as b. O(n log n).
std::vector<ImportedSeam> drawn_seams(const std::vector<ImportedPanel>& panels,
                                      const std::string& source, std::vector<Remark>& remarks);

}  // namespace toile
