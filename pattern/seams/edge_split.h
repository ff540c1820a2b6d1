// Cuts an edge of a pattern file in two.
#pragma once

#include <string>

#include "pattern/pattern.h"

namespace toile {

/// An edge that is cut in two. The part from its start keeps the number, the rest becomes the
/// panel's last edge.
struct EdgeSplit {
  EdgeRef edge;
  double share = 0.5;  ///< of the edge's length, from its start as drawn; within (0, 1)
  int rest = 0;        ///< number of the rest
};

/// The text of a pattern file with the edge cut, which keeps its shape. `pattern` is what the text
/// holds, and says its number of edges. All else stays as it is.
std::string with_split_edge(const std::string& text, const Pattern& pattern,
                            const EdgeSplit& split);

}  // namespace toile
