// The page of all figures: one HTML file that holds pictures, charts and tables.
#pragma once

#include <filesystem>
#include <string>

namespace toile::figures {

/// Gathers the sheets (fig*.json, by number) of the folder, with their pictures, into one page that
/// asks for nothing from the network. Throws Error when there is no sheet, or one is damaged.
std::string figures_page(const std::filesystem::path& folder);

}  // namespace toile::figures
