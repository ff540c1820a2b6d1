// The panels of a dressed garment side by side, as they lie flat.
#pragma once

#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// Panels on a sheet. Metres, y up.
struct SideBySide {
  std::vector<Vec2> flat;    ///< DressedGarment::flat, moved with its panel
  Vec2 size = Vec2::Zero();  ///< of the sheet, which begins at the origin
};

/// Lays the panels out in rows, the tallest first, about as wide as high. They keep their size and
/// are not turned.
SideBySide side_by_side(const DressedGarment& garment);

}  // namespace toile
