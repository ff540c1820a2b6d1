#include "pattern/mesh/sharp_corners.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "pattern/constants.h"
#include "pattern/mesh/outline_polygon.h"

namespace toile {

namespace {

/// An edge as seen from one of its ends.
struct Leaving {
  const EdgeCurve& curve;
  bool from_start = true;

  Vec2 at(double length) const {
    const double fraction = length / curve.length();
    return curve.at(from_start ? fraction : 1 - fraction);
  }
  EdgeCurve straight(double length) const {
    return from_start ? curve.straight_at_start(length) : curve.straight_at_end(length);
  }
  /// How far the curve lies off the chord to the point at `length`, metres.
  double off_chord(double length) const {
    if (curve.straight()) return 0;
    constexpr int samples = 16;
    double farthest = 0;
    for (int i = 1; i < samples; ++i) {
      farthest =
          std::max(farthest, distance_to_segment(at(length * i / samples), at(0), at(length)));
    }
    return farthest;
  }
};

/// Radians of cloth between two edges that leave a corner, by the points at `length` along them.
double opening(const Leaving& in, const Leaving& out, double length, bool counter_clockwise) {
  const Vec2 u = out.at(length) - out.at(0);
  const Vec2 v = in.at(length) - in.at(0);
  const double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
  return counter_clockwise ? angle : -angle;
}

/// Metres of the edges that have to be straight to open the corner; 0: none, or it can't be opened.
double straight_length(const Leaving& in, const Leaving& out, bool counter_clockwise) {
  constexpr double tip = 1e-4;
  constexpr double step = 1e-3;
  if (in.curve.straight() && out.curve.straight()) return 0;
  const double longest = std::min(in.curve.length(), out.curve.length()) / 2;
  const double drawn = opening(in, out, tip, counter_clockwise);
  if (longest < tip || drawn >= needle_angle || drawn < -max_corner_overlap) return 0;
  for (double length = step; length < longest; length += step) {
    if (std::max(in.off_chord(length), out.off_chord(length)) > max_outline_shift) return 0;
    if (opening(in, out, length, counter_clockwise) >= opened_corner) return length;
  }
  return 0;
}

}  // namespace

void open_sharp_corners(Pattern& pattern, std::vector<Remark>& remarks) {
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    PatternPanel& panel = pattern.panels[p];
    const bool counter_clockwise = signed_area(outline_polygon(panel).points) > 0;
    for (std::size_t i = 0; i < panel.outline.size(); ++i) {
      const OutlineStep step = panel.outline[i];
      const OutlineStep next = panel.outline[(i + 1) % panel.outline.size()];
      EdgeCurve& in_curve = panel.edges[static_cast<std::size_t>(step.edge)].curve;
      EdgeCurve& out_curve = panel.edges[static_cast<std::size_t>(next.edge)].curve;
      const Leaving in{in_curve, !step.forward};
      const Leaving out{out_curve, next.forward};
      const double length = straight_length(in, out, counter_clockwise);
      if (length == 0) continue;
      const double shift = std::max(in.off_chord(length), out.off_chord(length));
      const EdgeCurve straight_in = in.straight(length);
      const EdgeCurve straight_out = out.straight(length);
      in_curve = straight_in;
      out_curve = straight_out;
      remarks.push_back(
          {true, pattern.source + ": " + edge_name(pattern, {static_cast<int>(p), step.edge}) +
                     " meets edge " + std::to_string(next.edge) +
                     " too sharply to mesh; curves are straight over " +
                     number_text(length * 1000, 2) + " mm there, which moves them by " +
                     number_text(shift * 1000, 2) + " mm"});
    }
  }
}

}  // namespace toile
