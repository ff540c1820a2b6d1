#include "tools/address.h"

#include <string_view>

namespace toile {

std::string page_address(const std::filesystem::path& relative) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~/";
  std::string text = relative.is_absolute() ? "file://" : "./";
  for (const char c : relative.string()) {
    if (plain.find(c) != std::string_view::npos) {
      text += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    text += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return text;
}

}  // namespace toile
