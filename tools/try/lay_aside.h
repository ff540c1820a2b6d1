// Panels that nothing sews to the rest of a garment.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tools/find_seams/report.h"

namespace toile {

/// Panels that are laid aside.
struct LaidAside {
  std::vector<LeftOut> panels;
  double largest = 0;  ///< area of the most that is sewn together, as a share of what stays
};

/// Writes a pattern file anew, leaving out what is not sewn to its largest part by area. Parts with
/// a panel in `placed` stay: they need no seam to have a place. Returns what is newly left
/// out; without any, the file stays as it is. Throws Error for a file that is no pattern.
LaidAside lay_aside(const std::filesystem::path& file, const std::set<std::string>& placed);

}  // namespace toile
