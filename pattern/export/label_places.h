// Where there is room in a panel for its arrow and its texts.
#pragma once

#include <optional>
#include <vector>

#include "geometry/types.h"
#include "pattern/import/piece.h"

namespace toile {

/// The line in the direction `along` through the polygon that stays inside for longest, shortened
/// to `share` of that and to `max_length` metres. Of 41 lines side by side. The polygon is simple.
PieceLine longest_line_inside(const std::vector<Vec2>& polygon, const Vec2& along, double share,
                              double max_length);

/// A place where a box of `size` metres, upright, lies in the polygon and away from `lines`: its
/// middle. Of a grid of places it is the one nearest to the middle of the polygon. Nothing where
/// there is none.
std::optional<Vec2> room_for(const Vec2& size, const std::vector<Vec2>& polygon,
                             const std::vector<PieceLine>& lines);

}  // namespace toile
