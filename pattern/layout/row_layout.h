// Boxes laid out side by side in rows.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Puts boxes side by side, row after row away from a corner. Metres.
class RowFiller {
 public:
  /// Boxes lie `gap` apart and `border` from the ends of the rows, which are `width` long.
  RowFiller(double gap, double border, double width)
      : gap_(gap), border_(border), width_(width), next_(border, border) {}

  /// The corner of the next box that is nearest to where the rows begin. A box that is wider than a
  /// row has a row of its own.
  Vec2 add(const Vec2& size);

  /// From the corner to the ends of the longest and the last row, a gap behind each.
  Vec2 size() const { return {longest_, row_height_ + gap_ + next_.y()}; }

 private:
  double gap_;
  double border_;
  double width_;
  Vec2 next_;
  double row_height_ = 0;
  double longest_ = 0;
};

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
