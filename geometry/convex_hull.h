// The convex hull of points in the plane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Indices of the corners of the hull, counter-clockwise from the leftmost one, of equally left
/// ones the lowest [Andrew's monotone chain]. Points that lie on a side, or at another corner, are
/// none. Several points that are all alike give two indices; a single one gives none. O(n log n).
inline std::vector<int> convex_hull(const std::vector<Vec2>& points) {
  const auto turn = [&](int o, int a, int b) {
    return (points[a].x() - points[o].x()) * (points[b].y() - points[o].y()) -
           (points[a].y() - points[o].y()) * (points[b].x() - points[o].x());
  };
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(points[a].x(), points[a].y()) < std::pair(points[b].x(), points[b].y());
  });
  std::vector<int> hull;
  for (int pass = 0; pass < 2 && !order.empty(); ++pass) {
    const std::size_t start = hull.size();
    for (const int i : order) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), i) <= 0) {
        hull.pop_back();
      }
      hull.push_back(i);
    }
    hull.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return hull;
}

}  // namespace toile
