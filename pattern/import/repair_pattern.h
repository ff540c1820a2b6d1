// Repairs of pattern files that a program predicted, where one repair is plainly right.
#pragma once

#include <string>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// The text of a pattern file in GarmentCode's JSON, repaired; the text itself where nothing is to
/// be repaired. Each repair is a warning in `remarks` that names panel and edge.
///
/// - A stitch that sews the same two edges as one before it is left out.
/// - An outline that is open by up to 5 mm is closed.
/// - An edge without length is left out, and the edges behind it get lower numbers. Its stitch
/// goes.
///
/// Throws Error for text that is not JSON, and for a stitch to an edge that its panel does not
/// have. All else is left to parse_pattern() and check_pattern(), which refuse it.
std::string repaired_pattern(const std::string& text, const std::string& name,
                             std::vector<Remark>& remarks);

}  // namespace toile
