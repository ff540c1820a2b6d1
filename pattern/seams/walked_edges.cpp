#include "pattern/seams/walked_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/polygon.h"

namespace toile {

namespace {

/// Chords of an edge: enough for the tangents at its ends and the turning of its quarters.
constexpr int chords = 32;
static_assert(chords % 4 == 0);

/// Metres: a notch is drawn at the vertex that it names.
constexpr double at_notch = 1e-6;

double angle_between(const Vec2& from, const Vec2& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// An outline as it is seen from the panel's right side, counter-clockwise.
struct Walk {
  std::vector<std::vector<Vec2>> steps;  ///< points, each step from its first to its last one
  bool turned = false;                   ///< the walk runs against the outline
  bool mirrored = false;                 ///< the points are mirrored, left to right
};

Walk walked(const PatternPanel& panel, bool drawn_walk, bool turned_over) {
  Walk walk;
  std::vector<std::vector<Vec2>>& steps = walk.steps;
  std::vector<Vec2> outline;
  for (const OutlineStep& step : panel.outline) {
    std::vector<Vec2> points = panel.edges[step.edge].curve.sample(chords);
    if (!step.forward) std::reverse(points.begin(), points.end());
    outline.insert(outline.end(), points.begin(), points.end() - 1);
    steps.push_back(std::move(points));
  }
  const bool clockwise = signed_area(outline) < 0;
  walk.mirrored = (clockwise && drawn_walk) != turned_over;
  walk.turned = clockwise != walk.mirrored;
  if (walk.mirrored) {
    for (std::vector<Vec2>& points : steps) {
      for (Vec2& point : points) point.x() = -point.x();
    }
  }
  if (walk.turned) {
    std::reverse(steps.begin(), steps.end());
    for (std::vector<Vec2>& points : steps) std::reverse(points.begin(), points.end());
  }
  return walk;
}

const EdgeCurve& curve_of(const PatternPanel& panel, int edge) { return panel.edges[edge].curve; }

std::array<double, 4> turning_of_quarters(const std::vector<Vec2>& points) {
  std::array<double, 4> turning{};
  for (int k = 1; k < chords; ++k) {
    const double turn = angle_between(points[k] - points[k - 1], points[k + 1] - points[k]);
    // A point between two quarters belongs to both.
    turning[(k - 1) * 4 / chords] += turn / 2;
    turning[k * 4 / chords] += turn / 2;
  }
  return turning;
}

}  // namespace

std::vector<WalkedEdge> walked_edges(const Pattern& pattern, bool drawn_walk,
                                     const std::vector<char>& turned_over) {
  std::vector<WalkedEdge> edges;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    const Walk outline = walked(panel, drawn_walk, !turned_over.empty() && turned_over[p] != 0);
    const std::vector<std::vector<Vec2>>& steps = outline.steps;
    const std::size_t count = steps.size();
    const int first = static_cast<int>(edges.size());
    for (std::size_t i = 0; i < count; ++i) {
      const OutlineStep& step = panel.outline[outline.turned ? count - 1 - i : i];
      const std::vector<Vec2>& points = steps[i];
      const std::vector<Vec2>& before = steps[(i + count - 1) % count];
      WalkedEdge edge;
      edge.ref = {static_cast<int>(p), step.edge};
      edge.next = first + static_cast<int>((i + 1) % count);
      edge.previous = first + static_cast<int>((i + count - 1) % count);
      edge.forward = step.forward != outline.turned;
      edge.length = panel.edges[step.edge].curve.length();
      edge.turning = turning_of_quarters(points);
      edge.corner = std::numbers::pi -
                    angle_between(before[chords] - before[chords - 1], points[1] - points[0]);
      const Vec2 chord = (curve_of(panel, step.edge).end() - curve_of(panel, step.edge).start());
      const Vec2 warp(-std::sin(panel.grain), std::cos(panel.grain));
      const double across = std::abs(chord.x() * warp.y() - chord.y() * warp.x());
      edge.across_grain = across / std::max(chord.norm(), 1e-9);
      // The walk is counter-clockwise, so the outside lies to the right.
      const Vec2 walk = points[chords] - points[0];
      const Vec2 seen_warp(outline.mirrored ? -warp.x() : warp.x(), warp.y());
      edge.upwards =
          (walk.y() * seen_warp.x() - walk.x() * seen_warp.y()) / std::max(walk.norm(), 1e-9);
      edge.rise = walk.dot(seen_warp) / std::max(walk.norm(), 1e-9);
      const EdgeCurve& curve = curve_of(panel, step.edge);
      const Vec2 start = edge.forward ? curve.start() : curve.end();
      edge.notch = std::any_of(
          panel.notches.begin(), panel.notches.end(),
          [&](const PanelNotch& notch) { return (notch.at - start).norm() < at_notch; });
      edge.points = points;
      edges.push_back(edge);
    }
  }
  return edges;
}

WalkedEdge part_of(const WalkedEdge& edge, double from, double to) {
  WalkedEdge part = edge;
  part.length = (to - from) * edge.length;
  const auto at = [&edge](double share) -> Vec2 {
    const double place = std::clamp(share, 0.0, 1.0) * chords;
    const int before = std::min(static_cast<int>(place), chords - 1);
    return edge.points[before] + (place - before) * (edge.points[before + 1] - edge.points[before]);
  };
  for (int k = 0; k <= chords; ++k) part.points[k] = at(from + (to - from) * k / chords);
  part.turning = turning_of_quarters(part.points);
  if (from > 0) {
    part.corner = std::numbers::pi;
    part.notch = false;
  }
  // The warp keeps its direction.
  const double turn = angle_between(edge.points.back() - edge.points.front(),
                                    part.points.back() - part.points.front());
  part.rise = edge.rise * std::cos(turn) - edge.upwards * std::sin(turn);
  part.upwards = edge.upwards * std::cos(turn) + edge.rise * std::sin(turn);
  part.across_grain = std::abs(part.upwards);
  return part;
}

}  // namespace toile
