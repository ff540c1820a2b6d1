// Panels that nothing sews to the rest of a garment.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tools/find_seams/report.h"

namespace toile {

/// Writes a pattern file anew, leaving out what is not sewn to its largest part by area. Parts with
/// a panel in `placed` stay: they need no seam to have a place. Returns the panels that are newly
/// left out; without any, the file stays as it is. Throws Error for a file that is no pattern.
std::vector<LeftOut> lay_aside(const std::filesystem::path& file,
                               const std::set<std::string>& placed);

}  // namespace toile
