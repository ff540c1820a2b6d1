#include "pattern/mesh/cut_outs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/polygon.h"
#include "pattern/constants.h"
#include "pattern/mesh/outline_polygon.h"

namespace toile {

namespace {

using Loop = std::vector<Vec2>;

/// Of an edge length: a hole that comes nearer to the outline leaves needles. With half of it, a
/// strip between has triangles of 3 degrees, and the garment one subdivision less.
constexpr double least_strip = 0.1;

/// Of an edge length: twice the area of a narrower hole, over its girth, is less.
constexpr double least_width = 0.25;

bool within_one_another(const Loop& a, const Loop& b) {
  return inside(a, b.front()) || inside(b, a.front());
}

/// Metres from each point of one polygon to the other, the least; 0: they cross. O(n m).
double distance(const Loop& a, const Loop& b) {
  double least = std::numeric_limits<double>::infinity();
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x();
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2& p = a[i];
    const Vec2& q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Vec2& r = b[j];
      const Vec2& s = b[(j + 1) % b.size()];
      least = std::min({least, distance_to_segment(p, r, s), distance_to_segment(r, p, q)});
      if (side(p, q, r) * side(p, q, s) < 0 && side(r, s, p) * side(r, s, q) < 0) return 0;
    }
  }
  return least;
}

double girth(const Loop& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  }
  return length;
}

/// The loop without points that repeat the one before them.
Loop without_repeats(const Loop& drawn) {
  Loop loop;
  for (const Vec2& p : drawn) {
    if (loop.empty() || (p - loop.back()).norm() >= min_edge_length) loop.push_back(p);
  }
  while (loop.size() > 1 && (loop.front() - loop.back()).norm() < min_edge_length) loop.pop_back();
  return loop;
}

bool is_corner(const Loop& loop, std::size_t i) {
  const Vec2 in = loop[i] - loop[(i + loop.size() - 1) % loop.size()];
  const Vec2 out = loop[(i + 1) % loop.size()] - loop[i];
  return std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))) > max_turn_per_step;
}

std::vector<EdgeCurve> curves_of(const Loop& loop) {
  std::size_t first = 0;
  while (first < loop.size() && !is_corner(loop, first)) ++first;
  std::vector<EdgeCurve> curves;
  std::vector<EdgeCurve> lines;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t next = (first + k + 1) % loop.size();
    lines.push_back(EdgeCurve::line(loop[(first + k) % loop.size()], loop[next]));
    if (k + 1 < loop.size() && !is_corner(loop, next)) continue;
    curves.push_back(lines.size() == 1 ? lines.front() : EdgeCurve::chain(lines));
    lines.clear();
  }
  return curves;
}

}  // namespace

std::vector<CutOut> cut_outs_to_mesh(const PatternPanel& panel, double edge_length,
                                     const std::string& place, std::vector<Remark>& remarks) {
  std::vector<CutOut> cut_outs;
  if (panel.cut_outs.empty()) return cut_outs;
  const Loop outline = outline_polygon(panel).points;
  std::vector<Loop> taken;
  const auto problem = [&](const Loop& loop) -> std::optional<std::string> {
    if (loop.size() < 3) return "has no area";
    if (first_crossing(loop)) return "crosses itself";
    if (std::abs(signed_area(loop)) < std::sqrt(3.0) / 4 * edge_length * edge_length) {
      return "is smaller than a triangle at this edge length";
    }
    if (2 * std::abs(signed_area(loop)) / girth(loop) < least_width * edge_length) {
      return "is narrower than a quarter of the edge length";
    }
    if (distance(loop, outline) < least_strip * edge_length) {
      return "crosses the outline, or comes too near to it";
    }
    if (!inside(outline, loop.front())) return "lies outside the outline";
    for (const Loop& other : taken) {
      if (within_one_another(loop, other) || distance(loop, other) < least_strip * edge_length) {
        return "meets another cut-out";
      }
    }
    return std::nullopt;
  };
  for (std::size_t i = 0; i < panel.cut_outs.size(); ++i) {
    Loop loop = without_repeats(panel.cut_outs[i]);
    if (const auto wrong = problem(loop)) {
      remarks.push_back(
          {true, place + ", cut-out " + std::to_string(i) + " " + *wrong + ": it is not cut"});
      continue;
    }
    cut_outs.push_back({static_cast<int>(i), curves_of(loop)});
    taken.push_back(std::move(loop));
  }
  return cut_outs;
}

}  // namespace toile
