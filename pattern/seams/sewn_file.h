// Writes seams into a pattern file that has none.
#pragma once

#include <string>

#include "pattern/pattern.h"
#include "pattern/seams/find_seams.h"

namespace toile {

/// Whether the pattern file says that outlines are walked by GarmentCode's convention, see
/// walked_edges(). Throws Error as parse_pattern() does.
bool has_drawn_walk(const std::string& text, const std::string& name);

/// The text of a pattern file with these seams as its stitches. All else stays as it is, in the
/// same order; numbers are written in the shortest way that keeps their value. `drawn_walk`: seams
/// run end to start unless the stitch says otherwise; without it each stitch states its direction.
/// A given seam that the file has already is written as it was.
std::string with_stitches(const std::string& text, const Pattern& pattern,
                          const std::vector<FoundSeam>& seams, bool drawn_walk);

/// Spaces by which a JSON text is indented; -1: it is all in one line.
int indent_of(const std::string& text);

}  // namespace toile
