// Pieces that are drawn without a block.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pattern/import/dxf_blocks.h"

namespace toile {

/// The pieces in model space: each outermost closed outline, with what lies within or on it. They
/// are named piece1, piece2 and so on. `unit` is metres. What lies outside of all, texts excepted,
/// is counted in `ignored`.
///
/// Throws Error for an outline with a gap that is wider than max_outline_gap.
std::vector<DrawnPiece> loose_pieces(const DxfDrawing& drawing, bool layered, double unit,
                                     const std::string& source,
                                     std::map<std::string, int>& ignored);

}  // namespace toile
