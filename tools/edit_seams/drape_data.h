// A drape as the page of edit-seams draws it.
#pragma once

#include <filesystem>
#include <string>

namespace toile {

/// A JSON object.
///
/// - `garment` and `body`: each has `points` (metres, three numbers a point) and `triangles`.
/// - `panels`: of the garment's triangles, one index each.
/// - `seams`: by the name of each, the points along it.
/// - `verdict` and `warnings`: as the report of dress has them.
///
/// Throws Error as the readers of these files do.
std::string drape_json(const std::filesystem::path& garment, const std::filesystem::path& dressed,
                       const std::filesystem::path& report, const std::filesystem::path& body);

}  // namespace toile
