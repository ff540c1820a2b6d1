// The loads of a drape whose report of dress says how it was computed.
#pragma once

#include <filesystem>
#include <vector>

#include "cloth/loads/loads.h"
#include "tools/ease_map/dress_report.h"

namespace toile {

/// Where the meshed garment may be, in this order: where the report names it, and there beside the
/// dressed garment.
std::vector<std::filesystem::path> meshed_garments_of(const std::filesystem::path& dressed,
                                                      const DressReport& report);

/// Reads the meshed garment and measures the loads of `dressed`, in the order of its nodes and
/// triangles. The report has fabrics and no unknown forces. Throws Error as read_garment() does,
/// where the two are not the same garment, and where the report has no fabric of a panel.
Loads worn_loads(const DressedGarment& dressed, const std::filesystem::path& meshed,
                 const DressReport& report, const SurfaceDistance& skin);

}  // namespace toile
