// Text in the code pages of old files.
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Whether every byte of `text` is part of well-formed UTF-8. O(n).
bool is_utf8(std::string_view text);

/// `text` in UTF-8. `code_page` is a name that iconv knows, such as "CP1252". A code page that is
/// not known is taken for CP1252. Bytes without a meaning become U+FFFD.
std::string to_utf8(std::string_view text, const std::string& code_page);

}  // namespace toile
