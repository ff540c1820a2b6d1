#include "pattern/mesh/seam_steps.h"

#include <algorithm>
#include <cmath>

#include "pattern/constants.h"
#include "pattern/mesh/sewn_corners.h"

namespace toile {

namespace {

/// The furthest that `curve` turns within one of `count` equal steps.
double sharpest_turn(const EdgeCurve& curve, int count) {
  if (curve.straight()) return 0;
  double sharpest = 0;
  for (int i = 0; i < count; ++i) {
    sharpest = std::max(sharpest, curve.turning(static_cast<double>(i) / count,
                                                static_cast<double>(i + 1) / count));
  }
  return sharpest;
}

}  // namespace

EdgeSteps steps_along(const Pattern& pattern, double edge_length, const EdgeSteps& factors) {
  EdgeSteps steps;
  const auto wanted = [&](const EdgeCurve& curve) {
    const int by_length = std::max(
        1, static_cast<int>(std::ceil(curve.length() / edge_length - outline_step_tolerance)));
    const int max_count = std::max(max_step_refinement * by_length, max_steps_of_short_curve);
    int count = by_length;
    while (count < max_count && sharpest_turn(curve, count) > max_turn_per_step) {
      count = std::min(max_count, count + 1 + count / 8);
    }
    return count;
  };
  for (const PatternPanel& panel : pattern.panels) {
    std::vector<int>& counts = steps.emplace_back();
    for (const PatternEdge& edge : panel.edges) counts.push_back(wanted(edge.curve));
  }
  // With one step, a triangle on an edge whose ends are sewn together would be sewn to itself.
  SewnCorners corners(pattern);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    for (const auto& [edge, forward] : pattern.panels[p].outline) {
      const std::array<int, 2> ends = corners.ends({static_cast<int>(p), edge});
      if (ends[0] == ends[1]) steps[p][edge] = std::max(steps[p][edge], 2);
    }
  }
  for (std::size_t p = 0; p < factors.size(); ++p) {
    for (std::size_t e = 0; e < factors[p].size(); ++e) steps[p][e] *= factors[p][e];
  }
  for (const Stitch& stitch : pattern.stitches) {
    int& a = steps[stitch.a.panel][stitch.a.edge];
    int& b = steps[stitch.b.panel][stitch.b.edge];
    a = b = std::max(a, b);
  }
  return steps;
}

}  // namespace toile
