// Pieces of other sizes, which drawings state in full for the base size only.
#pragma once

#include <string>

#include "pattern/import/outline_edges.h"
#include "pattern/import/piece.h"

namespace toile {

/// Gives pieces of a size what only the piece of the same name in the base size has.
///
/// Grading programs write turn points, notches, counts and materials once, for the base size. The
/// outlines of all sizes have the same lines, each moved. So a mark lies on the line of the same
/// number, at the same share of its length, and as far from it.
///
/// - Quantity, material and category are taken over where a piece states none of them.
/// - Corners and notches are taken over where a piece has none of both and its outline has as many
///   lines. Where it has not, a remark names it. Corners are those that edges_of() finds in
///   the base size: so edges are as many and numbered alike, though another size turns less there.
///
/// Without a base size, and for that itself, nothing is done. O(n) of marks times lines, for all
/// pieces.
void complete_size(PieceDrawing& drawing, const std::string& size, const EdgeOptions& options);

}  // namespace toile
