#include "pattern/mesh/sewn_corners.h"

#include <algorithm>
#include <utility>

#include "pattern/mesh/seam_orientation.h"

namespace toile {

namespace {

std::size_t corners_of(const Pattern& pattern) {
  std::size_t corners = 0;
  for (const PatternPanel& panel : pattern.panels) corners += panel.outline.size();
  return corners;
}

}  // namespace

SewnCorners::SewnCorners(const Pattern& pattern) : pattern_(pattern), sewn_(corners_of(pattern)) {
  int corners = 0;
  for (const PatternPanel& panel : pattern.panels) {
    first_.push_back(corners);
    corners += static_cast<int>(panel.outline.size());
  }
  std::vector<Remark> said_elsewhere;
  const Orientation orientation = orient(pattern, said_elsewhere);
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const std::array<int, 2> a = ends(pattern.stitches[s].a);
    std::array<int, 2> b = ends(pattern.stitches[s].b);
    if (orientation.reversed[s]) std::swap(b[0], b[1]);
    for (std::size_t k = 0; k < 2; ++k) sewn_.join(a[k], b[k]);
  }
}

std::array<int, 2> SewnCorners::ends(const EdgeRef& ref) {
  const auto& outline = pattern_.panels[static_cast<std::size_t>(ref.panel)].outline;
  const auto step = std::find_if(outline.begin(), outline.end(),
                                 [&](const OutlineStep& s) { return s.edge == ref.edge; });
  const int at_step = static_cast<int>(step - outline.begin());
  std::array<int, 2> ends = {at(ref.panel, at_step),
                             at(ref.panel, (at_step + 1) % static_cast<int>(outline.size()))};
  if (!step->forward) std::swap(ends[0], ends[1]);
  return ends;
}

}  // namespace toile
