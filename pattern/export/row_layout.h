// Boxes laid out side by side in rows.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Where boxes lie on a sheet. Metres, y up.
struct RowLayout {
  std::vector<Vec2> corners;  ///< of each box: its lower left corner
  Vec2 size = Vec2::Zero();   ///< of the sheet
};

/// Lays boxes of the given sizes out in rows from the top, the tallest first, `gap` metres apart
/// and from the border. A row is `width` metres long at most, or as long as the widest box. Rows
/// become longer where the sheet would be higher than `max_height` otherwise.
RowLayout lay_out_rows(const std::vector<Vec2>& sizes, double gap, double width, double max_height);

}  // namespace toile
