// The pieces among the blocks of a DXF drawing.
#pragma once

#include <string>
#include <vector>

#include "io/dxf.h"
#include "pattern/pattern.h"

namespace toile {

/// The entities of one piece, in the drawing's unit. None is an insert.
struct DrawnPiece {
  std::string name;  ///< the block's
  std::vector<DxfEntity> entities;
  bool mirrored_twin = false;  ///< the block is inserted as drawn and mirrored
};

/// Entities of all pieces, nested inserts included, at most.
inline constexpr std::size_t max_piece_entities = 500'000;

/// The blocks that are pieces, in the file's order; dxf_pieces() says which are.
///
/// Throws Error, naming the block, for blocks that are nested deeper than 16, or in themselves. It
/// throws it for inserts beyond a billion units, and beyond max_piece_entities.
std::vector<DrawnPiece> pieces_in_blocks(const DxfDrawing& drawing, bool layered,
                                         const std::string& source, std::vector<Remark>& remarks);

}  // namespace toile
