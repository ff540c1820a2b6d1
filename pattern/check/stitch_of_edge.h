// Which stitch an edge is in.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "pattern/pattern.h"

namespace toile {

/// The stitch of an edge, seen from that edge.
struct EdgeStitch {
  int stitch = 0;  ///< index into Pattern::stitches
  EdgeRef other;   ///< the other side
};

/// By panel and edge; nothing when an edge is in two stitches, or sewn to itself.
std::optional<std::map<std::array<int, 2>, EdgeStitch>> stitch_of_edge(const Pattern& pattern);

}  // namespace toile
