#include "pattern/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "geometry/error.h"
#include "geometry/outline.h"

namespace toile {

namespace {

std::string centimetres(double length) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f cm", length * 100);
  return text;
}

void check_outline(const Pattern& pattern, int index) {
  const PatternPanel& panel = pattern.panels[static_cast<std::size_t>(index)];
  const auto place = [&](int edge) {
    return pattern.source + ": " + edge_name(pattern, {index, edge});
  };
  for (std::size_t e = 0; e < panel.edges.size(); ++e) {
    const EdgeCurve& curve = panel.edges[e].curve;
    if ((curve.end() - curve.start()).norm() < shortest_edge || curve.length() < shortest_edge) {
      throw Error(place(static_cast<int>(e)), "has zero length",
                  "remove it or move one of its vertices");
    }
  }
  std::vector<Vec2> points;
  std::vector<int> edge_of_segment;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& curve = panel.edges[static_cast<std::size_t>(step.edge)].curve;
    const int segments =
        curve.straight() ? 1 : 16 + static_cast<int>(32 * curve.turning() / std::numbers::pi);
    std::vector<Vec2> sample = curve.sample(segments);
    if (!step.forward) std::reverse(sample.begin(), sample.end());
    points.insert(points.end(), sample.begin(), sample.end() - 1);
    edge_of_segment.insert(edge_of_segment.end(), static_cast<std::size_t>(segments), step.edge);
  }
  if (const auto crossing = first_crossing(points)) {
    const int first = edge_of_segment[static_cast<std::size_t>((*crossing)[0])];
    const int second = edge_of_segment[static_cast<std::size_t>((*crossing)[1])];
    throw Error(
        place(first),
        first == second ? "crosses itself" : "crosses or touches edge " + std::to_string(second),
        "an outline must not meet itself; correct the vertices or the curvature");
  }
}

}  // namespace

void check_pattern(const Pattern& pattern, std::vector<Remark>& remarks) {
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    check_outline(pattern, static_cast<int>(p));
  }
  std::map<std::array<int, 2>, std::size_t> stitch_of;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    const std::string number = "stitch " + std::to_string(s);
    for (const EdgeRef& ref : {stitch.a, stitch.b}) {
      const auto [found, added] = stitch_of.try_emplace({ref.panel, ref.edge}, s);
      if (added) continue;
      throw Error(pattern.source + ": " + edge_name(pattern, ref),
                  found->second == s ? number + " sews it to itself"
                                     : "is in stitches " + std::to_string(found->second) + " and " +
                                           std::to_string(s),
                  "an edge is sewn once; split it where another seam begins");
    }
    const auto length = [&](const EdgeRef& ref) {
      return pattern.panels[static_cast<std::size_t>(ref.panel)]
          .edges[static_cast<std::size_t>(ref.edge)]
          .curve.length();
    };
    const double a = length(stitch.a);
    const double b = length(stitch.b);
    const double ratio = std::max(a, b) / std::min(a, b);
    if (ratio <= 1 + seam_note_ratio) continue;
    char shown[32];
    std::snprintf(shown, sizeof shown, "%.2f : 1", ratio);
    const bool warning = ratio > 1 + seam_warning_ratio;
    remarks.push_back({warning, pattern.source + ": " + edge_name(pattern, stitch.a) + " (" +
                                    centimetres(a) + ") is sewn to " +
                                    edge_name(pattern, stitch.b) + " (" + centimetres(b) + "), " +
                                    shown +
                                    (warning ? "; right only if the longer side is gathered"
                                             : "; the longer side is eased in")});
  }
}

}  // namespace toile
