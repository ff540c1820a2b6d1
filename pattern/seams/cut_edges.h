// A pattern with some of its edges cut, without its file.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "pattern/pattern.h"
#include "pattern/seams/edge_split.h"
#include "pattern/seams/find_seams.h"

namespace toile {

/// A place where an edge is cut.
struct EdgeCut {
  double share = 0.5;  ///< of the edge's length, from its start as drawn; within (0, 1)
  bool notch = false;  ///< what it is sewn to has a notch there
};

/// Per panel and edge as drawn: where it is cut, ascending.
using EdgeCuts = std::map<std::array<int, 2>, std::vector<EdgeCut>>;

/// A part of an edge as drawn, between two shares of its length.
struct EdgePart {
  int edge = 0;
  double from = 0;
  double to = 1;
  auto operator<=>(const EdgePart&) const = default;
};

/// An edge of a panel, or a part of it.
struct PanelPart {
  int panel = 0;
  EdgePart part;
  auto operator<=>(const PanelPart&) const = default;
};

struct CutPattern {
  Pattern pattern;
  std::vector<std::vector<EdgePart>> parts;  ///< per panel, per edge of `pattern`
  std::vector<EdgeSplit> splits;             ///< that make it of the drawn one, in their order
};

/// Each part keeps its shape. The first one of an edge keeps its number.
CutPattern with_cuts(const Pattern& drawn, const EdgeCuts& cuts);

/// The seams of one cut pattern in another one of the same drawing, and `more` seams, for which
/// others make way. Those of edges that are parted otherwise are left out.
FoundSeams moved_to(const FoundSeams& found, const CutPattern& from, const CutPattern& to,
                    const std::vector<std::array<PanelPart, 2>>& more);

}  // namespace toile
