// The page of all figures: one HTML file that holds pictures, charts and tables.
#pragma once

#include <filesystem>
#include <string>

namespace toile::figures {

/// Gathers the sheets of the folder (fig*.json by number, then limits.json), with their pictures,
/// into one page that asks for nothing from the network. Throws Error when there is no sheet, or
/// one is damaged.
std::string figures_page(const std::filesystem::path& folder);

}  // namespace toile::figures
