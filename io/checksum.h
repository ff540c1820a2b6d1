// What tells one content from another.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace toile {

/// The SHA-256 of the bytes, as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The SHA-256 of a file's content. Throws Error when it can't be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace toile
