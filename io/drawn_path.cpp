#include "io/drawn_path.h"

#include <algorithm>
#include <cmath>

namespace toile {

std::vector<Vec2> path_vertices(const DrawnPath& path, double tolerance) {
  constexpr double max_steps = 1000;
  std::vector<Vec2> points = {path.start};
  for (const DrawnSegment& segment : path.segments) {
    if (segment.curved) {
      const Vec2 from = points.back();
      // A chord over the share 1 / n of a curve leaves it by its second derivative / (8 n^2).
      const double bend = std::max((from - 2 * segment.control1 + segment.control2).norm(),
                                   (segment.control1 - 2 * segment.control2 + segment.end).norm());
      const auto steps = static_cast<int>(
          std::clamp(std::ceil(std::sqrt(0.75 * bend / tolerance)), 1.0, max_steps));
      for (int i = 1; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double s = 1 - t;
        points.push_back(s * s * s * from + 3 * s * s * t * segment.control1 +
                         3 * s * t * t * segment.control2 + t * t * t * segment.end);
      }
    }
    points.push_back(segment.end);
  }
  return points;
}

}  // namespace toile
