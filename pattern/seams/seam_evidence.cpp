#include "pattern/seams/seam_evidence.h"

namespace toile {

SeamEvidence seam_evidence(const Pattern& pattern, bool drawn_walk,
                           const std::vector<char>& turned_over) {
  SeamEvidence evidence;
  evidence.edges = walked_edges(pattern, drawn_walk, turned_over);
  evidence.turned_over = turned_over;
  evidence.turned_over.resize(pattern.panels.size(), 0);
  for (const PatternPanel& panel : pattern.panels) evidence.words.push_back(words_of(panel));
  evidence.fits = panel_fits(evidence.edges);
  evidence.shapes = edge_shapes(evidence.edges, evidence.fits);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    evidence.side.push_back(pattern.panels[p].side_unknown ? 0 : evidence.words[p].side);
  }
  evidence.mirror = mirror_partners(evidence.edges, evidence.fits, evidence.words);
  return evidence;
}

SeamEvidence heeding(SideNames sides, SeamEvidence evidence) {
  for (int& side : evidence.side) {
    if (sides == SideNames::exchanged) side = -side;
    if (sides == SideNames::ignored) side = 0;
  }
  return evidence;
}

double turning_of(const WalkedEdge& edge) {
  return edge.turning[0] + edge.turning[1] + edge.turning[2] + edge.turning[3];
}

int edge_across(const std::vector<WalkedEdge>& edges, int edge) {
  const int across = edges[edges[edge].next].next;
  return across != edge && edges[edges[across].next].next == edge ? across : -1;
}

}  // namespace toile
