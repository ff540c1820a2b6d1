// The loads of a drape whose report of dress says how it was computed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cloth/loads/loads.h"
#include "tools/ease_map/dress_report.h"

namespace toile {

/// Loads, or why there are none.
struct WornLoads {
  std::optional<Loads> loads;
  std::string why_not;  ///< a sentence's end, after "no strain, tension and pressure: "
};

/// Where the meshed garment is looked for, in this order: `given`; where the report names it; there
/// beside the dressed garment.
std::filesystem::path meshed_garment_of(const std::filesystem::path& dressed,
                                        const std::optional<std::filesystem::path>& given,
                                        const DressReport& report);

/// Reads the meshed garment and measures the loads of `dressed`, in the order of its nodes and
/// triangles. The report has fabrics. Throws Error as read_garment() does, and where the two are
/// not the same garment.
WornLoads worn_loads(const DressedGarment& dressed, const std::filesystem::path& meshed,
                     const DressReport& report, const SurfaceDistance& skin);

}  // namespace toile
