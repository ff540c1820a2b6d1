// A drape as the page of edit-seams draws it.
#pragma once

#include <filesystem>
#include <string>

namespace toile {

/// JSON: `garment` and `body`, each with `points` (metres, three a point) and `triangles`; the
/// garment's `panels`, one index a triangle; `seams`, the points along each seam by its name; the
/// report's `verdict` and `warnings`. Throws Error as the readers of these files do.
std::string drape_json(const std::filesystem::path& garment, const std::filesystem::path& dressed,
                       const std::filesystem::path& report, const std::filesystem::path& body);

}  // namespace toile
