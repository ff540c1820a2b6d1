#include "pattern/check/check_pattern.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/text.h"
#include "pattern/constants.h"
#include "pattern/mesh/outline_polygon.h"
#include "pattern/mesh/sewn_corners.h"

namespace toile {

namespace {

/// Throws Error where two straight edges leave less cloth between them than a needle. No mesh of
/// the panel could do without that angle.
void check_corners(const PatternPanel& panel, bool counter_clockwise,
                   const std::function<std::string(int)>& place) {
  const std::size_t count = panel.outline.size();
  const auto run = [&](const OutlineStep& step) -> Vec2 {
    const EdgeCurve& curve = panel.edges[static_cast<std::size_t>(step.edge)].curve;
    return step.forward ? Vec2(curve.end() - curve.start()) : Vec2(curve.start() - curve.end());
  };
  for (std::size_t i = 0; i < count; ++i) {
    const OutlineStep& step = panel.outline[i];
    const OutlineStep& next = panel.outline[(i + 1) % count];
    if (!panel.edges[static_cast<std::size_t>(step.edge)].curve.straight() ||
        !panel.edges[static_cast<std::size_t>(next.edge)].curve.straight()) {
      continue;
    }
    const Vec2 in = run(step);
    const Vec2 out = run(next);
    const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    const double angle = std::numbers::pi - (counter_clockwise ? turn : -turn);
    if (angle <= 0 || angle >= needle_angle) continue;
    throw Error(place(step.edge),
                "meets edge " + std::to_string(next.edge) + " at " +
                    number_text(to_degrees(angle), 2) + " degrees",
                "no triangle fits into that corner; widen it or cut it off");
  }
}

void check_outline(const Pattern& pattern, int index) {
  const PatternPanel& panel = pattern.panels[static_cast<std::size_t>(index)];
  const auto place = [&](int edge) {
    return pattern.source + ": " + edge_name(pattern, {index, edge});
  };
  for (const auto& [edge, forward] : panel.outline) {
    const EdgeCurve& curve = panel.edges[static_cast<std::size_t>(edge)].curve;
    if ((curve.end() - curve.start()).norm() < min_edge_length) {
      throw Error(place(edge), "ends where it starts", "split it in two");
    }
  }
  const auto& [points, edge_of_segment] = outline_polygon(panel);
  check_corners(panel, signed_area(points) > 0, place);
  if (const auto crossing = first_crossing(points)) {
    const int first = edge_of_segment[static_cast<std::size_t>((*crossing)[0])];
    const int second = edge_of_segment[static_cast<std::size_t>((*crossing)[1])];
    throw Error(
        place(first),
        first == second ? "crosses itself" : "crosses or touches edge " + std::to_string(second),
        "an outline must not meet itself; correct the vertices or the curvature");
  }
}

double length_of(const Pattern& pattern, const EdgeRef& ref) {
  return pattern.panels[static_cast<std::size_t>(ref.panel)]
      .edges[static_cast<std::size_t>(ref.edge)]
      .curve.length();
}

std::string times(double ratio) { return fixed_number(ratio, 2) + " : 1"; }

/// The sewn corner at each end of every stitch, by number: stitches that share one meet there.
std::vector<std::array<int, 2>> ends_of(const Pattern& pattern) {
  SewnCorners corners(pattern);
  std::vector<std::array<int, 2>> ends;
  for (const Stitch& stitch : pattern.stitches) ends.push_back(corners.ends(stitch.a));
  return ends;
}

/// "panel 'a', edge 1 and 'b', edges 4, 5".
std::string edges_named(const Pattern& pattern, const std::vector<EdgeRef>& refs) {
  std::string text;
  for (std::size_t i = 0; i < refs.size(); ++i) {
    const bool same = i > 0 && refs[i].panel == refs[i - 1].panel;
    const bool more = i + 1 < refs.size() && refs[i + 1].panel == refs[i].panel;
    if (!same) {
      text += i == 0 ? "panel '" : " and '";
      text += pattern.panels[static_cast<std::size_t>(refs[i].panel)].name;
      text += more ? "', edges " : "', edge ";
    } else {
      text += ", ";
    }
    text += std::to_string(refs[i].edge);
  }
  return text;
}

/// Seams in a line that a remark names one by one.
constexpr std::size_t max_named_seams = 4;

/// Seams with sides of different length that nobody declared: one remark for each line of them.
void remark_on_lengths(const Pattern& pattern, std::vector<Remark>& remarks) {
  const auto ratio_of = [&](const Stitch& stitch) {
    const double a = length_of(pattern, stitch.a);
    const double b = length_of(pattern, stitch.b);
    return std::max(a, b) / std::min(a, b);
  };
  const auto ends = ends_of(pattern);
  for (const bool warning : {false, true}) {
    std::vector<std::size_t> unequal;
    for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
      const double ratio = ratio_of(pattern.stitches[s]);
      if (pattern.stitches[s].gathered || ratio <= 1 + gather_threshold) continue;
      if (warning == (ratio > 1 + seam_warning_threshold)) unequal.push_back(s);
    }
    while (!unequal.empty()) {
      std::vector<std::size_t> line = {unequal.front()};
      unequal.erase(unequal.begin());
      for (std::size_t i = 0; i < line.size(); ++i) {
        const auto meets = [&](std::size_t s) {
          return std::any_of(ends[s].begin(), ends[s].end(), [&](int end) {
            return end == ends[line[i]][0] || end == ends[line[i]][1];
          });
        };
        std::copy_if(unequal.begin(), unequal.end(), std::back_inserter(line), meets);
        unequal.erase(std::remove_if(unequal.begin(), unequal.end(), meets), unequal.end());
      }
      std::sort(line.begin(), line.end());
      std::vector<EdgeRef> longer;
      std::vector<EdgeRef> shorter;
      for (const std::size_t s : line) {
        longer.push_back(pattern.stitches[s].a);
        shorter.push_back(pattern.stitches[s].b);
        if (length_of(pattern, longer.back()) < length_of(pattern, shorter.back())) {
          std::swap(longer.back(), shorter.back());
        }
      }
      // Of a long line, the seam that is most unequal stands for all.
      const std::size_t worst = static_cast<std::size_t>(
          std::max_element(line.begin(), line.end(),
                           [&](std::size_t s, std::size_t t) {
                             return ratio_of(pattern.stitches[s]) < ratio_of(pattern.stitches[t]);
                           }) -
          line.begin());
      const EdgeRef worst_longer = longer[worst];
      const EdgeRef worst_shorter = shorter[worst];
      double lengths[2] = {0, 0};
      for (const EdgeRef& ref : longer) lengths[0] += length_of(pattern, ref);
      for (const EdgeRef& ref : shorter) lengths[1] += length_of(pattern, ref);
      std::string sides = edges_named(pattern, longer) + " (" + centimetres(lengths[0], 2) + ") " +
                          (line.size() > 1 ? "are" : "is") + " sewn to " +
                          edges_named(pattern, shorter) + " (" + centimetres(lengths[1], 2) +
                          "), " + times(lengths[0] / lengths[1]);
      if (line.size() > max_named_seams) {
        const double a = length_of(pattern, worst_longer);
        const double b = length_of(pattern, worst_shorter);
        sides = edge_name(pattern, worst_longer) + " (" + centimetres(a, 2) + ") is sewn to " +
                edge_name(pattern, worst_shorter) + " (" + centimetres(b, 2) + "), " +
                times(a / b) + ", the most unequal of " + std::to_string(line.size()) +
                " seams in a line, together " + times(lengths[0] / lengths[1]);
      }
      remarks.push_back(
          {warning, pattern.source + ": " + sides +
                        (warning ? "; right only if the longer side is gathered: say so by "
                                   "\"gather\": true in the stitch"
                                 : "; the longer side is eased in")});
    }
  }
  for (const Stitch& stitch : pattern.stitches) {
    const double ratio = ratio_of(stitch);
    if (!stitch.gathered || stitch.fullness == 0 ||
        std::abs(ratio / stitch.fullness - 1) <= fullness_tolerance) {
      continue;
    }
    remarks.push_back({true, pattern.source + ": " + edge_name(pattern, stitch.a) + " (" +
                                 centimetres(length_of(pattern, stitch.a), 2) + ") and " +
                                 edge_name(pattern, stitch.b) + " (" +
                                 centimetres(length_of(pattern, stitch.b), 2) + ") are drawn " +
                                 times(ratio) + ", but declared gathered " +
                                 times(stitch.fullness)});
  }
}

}  // namespace

void warn_of_outlines(const Pattern& pattern, std::vector<Remark>& remarks) {
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    if (!pattern.panels[p].left_out.empty()) continue;
    try {
      check_outline(pattern, static_cast<int>(p));
    } catch (const Error& error) {
      remarks.push_back({true, std::string(error.what()) + "; mesh-pattern refuses it as it is"});
    }
  }
}

void check_pattern(const Pattern& pattern, std::vector<Remark>& remarks) {
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    check_outline(pattern, static_cast<int>(p));
  }
  std::map<std::array<int, 2>, std::size_t> stitch_of;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    const std::string number = "stitch " + std::to_string(s);
    for (const EdgeRef& ref : {stitch.a, stitch.b}) {
      const bool is_itself = stitch.a.panel == stitch.b.panel && stitch.a.edge == stitch.b.edge;
      if (stitch.layered && !is_itself) continue;
      const auto [found, added] = stitch_of.try_emplace({ref.panel, ref.edge}, s);
      if (added) continue;
      throw Error(
          pattern.source + ": " + edge_name(pattern, ref),
          found->second == s
              ? number + " sews it to itself"
              : "is in stitches " + std::to_string(found->second) + " and " + std::to_string(s),
          "an edge is sewn once; split it where another seam begins, or say \"layer\": true in "
          "the stitch of a panel that lies upon it");
    }
  }
  remark_on_lengths(pattern, remarks);
}

}  // namespace toile
