// Addresses of files in pages.
#pragma once

#include <filesystem>
#include <string>

namespace toile {

/// A path relative to a page as an address there, such as "./a%20shirt/ease.html". All but letters,
/// digits and some marks are written by their bytes.
std::string page_address(const std::filesystem::path& relative);

}  // namespace toile
