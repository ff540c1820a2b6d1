#include "pattern/export/label_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "geometry/polygon.h"

namespace toile {

namespace {

constexpr int line_count = 41;
constexpr int grid_count = 48;

Eigen::AlignedBox2d bounds_of(const std::vector<Vec2>& points) {
  Eigen::AlignedBox2d box;
  for (const Vec2& point : points) box.extend(point);
  return box;
}

/// Whether the segment meets the box.
bool meets(const Eigen::AlignedBox2d& box, const Vec2& from, const Vec2& to) {
  double low = 0;
  double high = 1;
  const Vec2 run = to - from;
  for (int k = 0; k < 2; ++k) {
    if (run[k] == 0) {
      if (from[k] < box.min()[k] || from[k] > box.max()[k]) return false;
      continue;
    }
    const double a = (box.min()[k] - from[k]) / run[k];
    const double b = (box.max()[k] - from[k]) / run[k];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return low <= high;
}

}  // namespace

PieceLine longest_line_inside(const std::vector<Vec2>& polygon, const Vec2& along, double share,
                              double max_length) {
  const Vec2 across(-along.y(), along.x());
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (const Vec2& point : polygon) {
    low = std::min(low, across.dot(point));
    high = std::max(high, across.dot(point));
  }
  PieceLine best;
  double longest = 0;
  for (int i = 1; i <= line_count; ++i) {
    // From the middle to both sides: of lines as long, the one in the middle is taken.
    const int step = i / 2 * (i % 2 == 0 ? 1 : -1);
    const double offset = (low + high) / 2 + step * (high - low) / (line_count + 1);
    std::vector<double> crossings;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2& a = polygon[k];
      const Vec2& b = polygon[(k + 1) % polygon.size()];
      const double from = across.dot(a) - offset;
      const double to = across.dot(b) - offset;
      if ((from < 0) == (to < 0)) continue;
      crossings.push_back(along.dot(a + from / (from - to) * (b - a)));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const double length = crossings[k + 1] - crossings[k];
      if (length <= 1.02 * longest) continue;
      longest = length;
      const Vec2 middle = offset * across + (crossings[k] + crossings[k + 1]) / 2 * along;
      const Vec2 half = std::min(share * length, max_length) / 2 * along;
      best = {middle - half, middle + half};
    }
  }
  return best;
}

std::optional<Vec2> room_for(const Vec2& size, const std::vector<Vec2>& polygon,
                             const std::vector<PieceLine>& lines) {
  const Eigen::AlignedBox2d whole = bounds_of(polygon);
  std::optional<Vec2> best;
  double least = std::numeric_limits<double>::max();
  for (int i = 1; i < grid_count; ++i) {
    for (int k = 1; k < grid_count; ++k) {
      const Vec2 at = whole.min() + whole.sizes().cwiseProduct(Vec2(i, k)) / grid_count;
      const double distance = (at - whole.center()).norm();
      if (distance >= least || !inside(polygon, at)) continue;
      const Eigen::AlignedBox2d box(Vec2(at - size / 2), Vec2(at + size / 2));
      bool free = true;
      for (std::size_t p = 0; p < polygon.size() && free; ++p) {
        free = !meets(box, polygon[p], polygon[(p + 1) % polygon.size()]);
      }
      for (std::size_t p = 0; p < lines.size() && free; ++p) {
        free = !meets(box, lines[p].from, lines[p].to);
      }
      if (!free) continue;
      least = distance;
      best = at;
    }
  }
  return best;
}

}  // namespace toile
