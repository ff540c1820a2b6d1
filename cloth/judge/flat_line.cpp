#include "cloth/judge/flat_line.h"

#include <algorithm>
#include <cmath>

namespace toile {

std::array<Vec2, 3> flat_corners(const PanelMesh& garment, int triangle) {
  const Triangle& corners = garment.triangles[triangle];
  return {garment.flat[corners[0]], garment.flat[corners[1]], garment.flat[corners[2]]};
}

double length_within(const std::array<Vec2, 3>& corners, const Vec2& from, const Vec2& direction) {
  double low = 0;
  double high = 1e300;
  for (int i = 0; i < 3; ++i) {
    const Vec2& p = corners[i];
    const Vec2 edge = corners[(i + 1) % 3] - p;
    const double inside = edge.x() * (from - p).y() - edge.y() * (from - p).x();
    const double rate = edge.x() * direction.y() - edge.y() * direction.x();
    if (std::abs(rate) < 1e-15) {
      if (inside < 0) return 0;
    } else if (rate > 0) {
      low = std::max(low, -inside / rate);
    } else {
      high = std::min(high, -inside / rate);
    }
  }
  return high - low;
}

}  // namespace toile
