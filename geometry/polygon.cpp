#include "geometry/polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <numeric>

#include "geometry/closest_points.h"

namespace toile {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int side(const Vec2& a, const Vec2& b, const Vec2& c) {
  return static_cast<int>(CGAL::orientation(
      Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()), Kernel::Point_2(c.x(), c.y())));
}

/// Whether `point`, a point of the line through a and b, lies between them.
bool between(const Vec2& a, const Vec2& b, const Vec2& point) {
  return std::min(a.x(), b.x()) <= point.x() && point.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= point.y() && point.y() <= std::max(a.y(), b.y());
}

bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const int c_side = side(a, b, c);
  const int d_side = side(a, b, d);
  const int a_side = side(c, d, a);
  const int b_side = side(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && between(a, b, c)) || (d_side == 0 && between(a, b, d)) ||
         (a_side == 0 && between(c, d, a)) || (b_side == 0 && between(c, d, b));
}

}  // namespace

double signed_area(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    // Relative to the first point, so that a polygon far from the origin loses no digits.
    const Vec2 a = outline[i] - outline[0];
    const Vec2 b = outline[(i + 1) % outline.size()] - outline[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

std::optional<std::array<int, 2>> first_crossing(const std::vector<Vec2>& outline) {
  const int count = static_cast<int>(outline.size());
  const auto point = [&](int i) -> const Vec2& {
    return outline[static_cast<std::size_t>(i % count)];
  };
  for (int i = 0; i < count; ++i) {
    if (point(i) == point(i + 1)) return std::array{i, (i + 1) % count};
    const bool folds = side(point(i), point(i + 1), point(i + 2)) == 0 &&
                       (point(i + 1) - point(i)).dot(point(i + 2) - point(i + 1)) < 0;
    if (folds) return std::array{i, (i + 1) % count};
  }
  const auto left = [&](int i) { return std::min(point(i).x(), point(i + 1).x()); };
  const auto right = [&](int i) { return std::max(point(i).x(), point(i + 1).x()); };
  std::vector<int> order(outline.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
  std::optional<std::array<int, 2>> found;
  std::vector<int> open;
  for (const int i : order) {
    std::erase_if(open, [&](int j) { return right(j) < left(i); });
    for (const int j : open) {
      if ((i + 1) % count == j || (j + 1) % count == i) continue;
      if (!meet(point(i), point(i + 1), point(j), point(j + 1))) continue;
      const std::array pair{std::min(i, j), std::max(i, j)};
      if (!found || pair < *found) found = pair;
    }
    open.push_back(i);
  }
  return found;
}

bool inside(const std::vector<Vec2>& outline, const Vec2& point) {
  bool in = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2& b = outline[(i + 1) % outline.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) in = !in;
  }
  return in;
}

double distance_to_segment(const Vec2& point, const Vec2& from, const Vec2& to) {
  return (point - from - closest_on_segment(point, from, to) * (to - from)).norm();
}

}  // namespace toile
