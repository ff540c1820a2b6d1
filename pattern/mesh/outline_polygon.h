// A panel's outline as a polygon.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Chords along an outline, in its order. Curves are followed by 16 chords and more, one for each 6
/// degrees of turning.
struct OutlinePolygon {
  std::vector<Vec2> points;          ///< metres, in the panel's drawing
  std::vector<int> edge_of_segment;  ///< segment i runs from point i to the next
};

OutlinePolygon outline_polygon(const PatternPanel& panel);

}  // namespace toile
