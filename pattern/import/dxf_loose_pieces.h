// Pieces that are drawn without a block.
#pragma once

#include <string>
#include <vector>

#include "pattern/import/dxf_blocks.h"
#include "pattern/import/piece.h"

namespace toile {

/// The pieces in model space: each outermost closed outline, with what lies within or on it. They
/// are named piece1, piece2 and so on. `unit` is metres. What lies outside of all, texts excepted,
/// is counted in `result.ignored`. Outlines with a gap that is wider than max_outline_gap are in
/// `result.left_out`.
std::vector<DrawnPiece> loose_pieces(const DxfDrawing& drawing, bool layered, double unit,
                                     const std::string& source, PieceDrawing& result);

}  // namespace toile
