// A drape as the page of edit-seams draws it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toile {

/// A JSON object.
///
/// - `garment` and `body`: each has `points` (metres, three numbers a point) and `triangles`.
/// - `panels`: of the garment's triangles, one index each.
/// - `seams`: by the name of each, the points along it.
/// - `verdict`: as the report of dress has it.
/// - `reason`: why that is the verdict; empty where it is `sewn`.
/// - `warnings`: those given, of body and pattern, then those of the report.
///
/// Throws Error as the readers of these files do.
std::string drape_json(const std::filesystem::path& garment, const std::filesystem::path& dressed,
                       const std::filesystem::path& report, const std::filesystem::path& body,
                       std::vector<std::string> warnings);

}  // namespace toile
