#include "pattern/seams/cut_edges.h"

#include <algorithm>
#include <set>
#include <utility>

namespace toile {

CutPattern with_cuts(const Pattern& drawn, const EdgeCuts& cuts) {
  CutPattern cut{drawn, {}, {}};
  for (const PatternPanel& panel : drawn.panels) {
    std::vector<EdgePart>& parts = cut.parts.emplace_back();
    for (std::size_t e = 0; e < panel.edges.size(); ++e) parts.push_back({static_cast<int>(e)});
  }
  for (const auto& [place, shares] : cuts) {
    PatternPanel& panel = cut.pattern.panels[place[0]];
    std::vector<EdgePart>& parts = cut.parts[place[0]];
    int edge = place[1];
    double done = 0;
    for (const EdgeCut& at : shares) {
      const int rest = static_cast<int>(panel.edges.size());
      const double share = (at.share - done) / (1 - done);
      cut.splits.push_back({{place[0], edge}, share, rest});
      auto [first, second] = panel.edges[edge].curve.cut_at(share);
      panel.edges.push_back(panel.edges[edge]);
      panel.edges[edge].curve = std::move(first);
      panel.edges[rest].curve = std::move(second);
      if (at.notch) panel.notches.push_back({0, panel.edges[rest].curve.start(), {}});
      const auto step =
          std::find_if(panel.outline.begin(), panel.outline.end(),
                       [edge](const OutlineStep& outline) { return outline.edge == edge; });
      panel.outline.insert(step->forward ? step + 1 : step, {rest, step->forward});
      parts.push_back({place[1], at.share, 1});
      parts[edge].to = at.share;
      edge = rest;
      done = at.share;
    }
  }
  return cut;
}

FoundSeams moved_to(const FoundSeams& found, const CutPattern& from, const CutPattern& to,
                    const std::vector<std::array<PanelPart, 2>>& more) {
  std::map<PanelPart, EdgeRef> place;
  for (std::size_t p = 0; p < to.parts.size(); ++p) {
    const int panel = static_cast<int>(p);
    for (std::size_t e = 0; e < to.parts[p].size(); ++e) {
      place[{panel, to.parts[p][e]}] = {panel, static_cast<int>(e)};
    }
  }
  std::set<PanelPart> taken;
  for (const auto& [a, b] : more) taken.insert({a, b});
  FoundSeams moved = found;
  std::erase_if(moved.seams, [&](FoundSeam& seam) {
    for (EdgeRef* side : {&seam.a, &seam.b}) {
      const PanelPart part{side->panel, from.parts[side->panel][side->edge]};
      const auto at = place.find(part);
      if (at == place.end() || taken.contains(part)) return true;
      *side = at->second;
    }
    return false;
  });
  for (const auto& [a, b] : more) {
    const auto at_a = place.find(a);
    const auto at_b = place.find(b);
    if (at_a == place.end() || at_b == place.end()) continue;
    FoundSeam seam;
    seam.a = at_a->second;
    seam.b = at_b->second;
    moved.seams.push_back(seam);
  }
  return moved;
}

}  // namespace toile
