#include "pattern/mesh/outline_polygon.h"

#include <algorithm>
#include <numbers>

namespace toile {

OutlinePolygon outline_polygon(const PatternPanel& panel) {
  OutlinePolygon polygon;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& curve = panel.edges[static_cast<std::size_t>(step.edge)].curve;
    const int segments =
        curve.straight() ? 1 : 16 + static_cast<int>(32 * curve.turning() / std::numbers::pi);
    std::vector<Vec2> sample = curve.sample(segments);
    if (!step.forward) std::reverse(sample.begin(), sample.end());
    polygon.points.insert(polygon.points.end(), sample.begin(), sample.end() - 1);
    polygon.edge_of_segment.insert(polygon.edge_of_segment.end(),
                                   static_cast<std::size_t>(segments), step.edge);
  }
  return polygon;
}

}  // namespace toile
