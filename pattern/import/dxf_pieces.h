// Pattern pieces from DXF, by the layers of AAMA and ASTM D6673.
#pragma once

#include <string>

#include "io/dxf.h"
#include "pattern/import/drawing_options.h"
#include "pattern/import/piece.h"

namespace toile {

/// The pieces of a DXF drawing.
///
/// - A block with an outline is a piece, inserted or not. Where it is inserted, it stands as the
///   first insert puts it. What a piece inserts without an outline of its own belongs to it.
/// - A block that only inserts pieces is a sheet. One that inserts a single piece adds its own
///   texts and marks to that.
/// - Outlines in model space are pieces, too. What lies within them belongs to them.
/// - Layers: 1 boundary, 2 turn points, 4 and 80 to 83 notches, 6 mirror line, 7 grain. 8 are
///   internal lines, 11 cut-outs, 13 drill holes, 14 the sew line. 3, 5, 9, 10, 15 and 84 to 87 are
///   known and not used. All others are counted in `ignored`. Drawings without anything on 1 and 14
///   have outlines on any layer; closed lines within them are internal lines.
/// - The sew line bounds a piece where there is one. With a warning, the boundary does if the line
///   leaves it or cuts much of it off. A closed internal line that runs along the
///   whole boundary, within 60 mm of it, is a sew line: Valentina writes it so.
/// - A piece is a pair if its texts say so, or if a second insert is mirrored.
///
/// A piece is left out whose outline has a gap wider than max_outline_gap. So is a block with two
/// outlines beside each other. An outline within the other is a cut-out, with a warning.
///
/// Throws Error when no piece is there, or none but those left out, and as drawing_unit() does.
PieceDrawing dxf_pieces(const DxfDrawing& drawing, const std::string& source,
                        const DrawingOptions& options);

}  // namespace toile
