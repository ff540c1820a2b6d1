// Reads the pieces of a pattern from an SVG drawing.
#pragma once

#include <string>
#include <string_view>

#include "pattern/import/drawing_options.h"
#include "pattern/import/piece.h"

namespace toile {

/// Reads an SVG drawing as a pattern.
///
/// FreeSewing's classes are known, in drawings of others too. A path of the class `fabric`,
/// `lining`, `interfacing` or `canvas` is a seam line. With `sa` as well it is the line to cut
/// along, the outline of a piece only where that has no seam line. Cut-on-fold marks, grain arrows,
/// notches, names and numbers to cut are read. A piece on the fold is half and has `fold`.
///
/// In a drawing without such classes, every closed path is a piece, unless it lies inside of
/// another one. Names come from labels, titles, ids, the group or the text inside, the first that
/// there is. Loose lines are joined within max_outline_gap. What lies inside of an outline:
///
/// - a closed path that belongs to the same element, or that is named a cut-out, is a cut-out;
/// - a circle of at most 10 mm is a drill hole;
/// - a closed path that runs along all of the outline, see runs_along(), is the seam line, and the
///   outline is the cut line;
/// - any other path is an internal line, closed or open.
///
/// A drawing that states no unit of length has 96 pixels an inch, with a remark. The user's unit is
/// that of the numbers in the drawing, whatever its width and viewBox say.
///
/// Outlines that can't be read, and those with a gap, are left out. The gap is named with its size,
/// and its place in the drawing's numbers.
///
/// Throws Error as parse_svg() and drawing_unit() do, beyond max_panels outlines, when no outline
/// is closed, and for allowances, cut-outs and folds that can't be read.
PieceDrawing svg_pieces(std::string_view text, const std::string& source,
                        const DrawingOptions& options);

}  // namespace toile
