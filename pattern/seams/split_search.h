// Finds seams of one edge to several, such as of a sleeve cap to the armholes of front and back.
#pragma once

#include <string>
#include <vector>

#include "pattern/seams/edge_split.h"
#include "pattern/seams/find_seams.h"

namespace toile {

/// Seams, and the pattern whose edges they name.
struct SplitSeams {
  std::string text;               ///< the pattern file with its edges cut
  Pattern pattern;                ///< what it holds
  std::vector<EdgeSplit> splits;  ///< in the order in which they are made
  FoundSeams found;
};

/// As find_seams(), with edges cut where that makes a garment of a higher score. An edge is cut
/// where it is about as long as several that follow each other on the border of the garment found
/// before. Edges of given seams are not cut, and none unless seams of all parts are likely then.
///
/// `text` is the file, of the name `name`, whose panels that are not left out are `pattern`. Throws
/// Error as find_seams() does.
SplitSeams find_split_seams(const std::string& text, const std::string& name,
                            const Pattern& pattern, const FindSeamsOptions& options);

}  // namespace toile
