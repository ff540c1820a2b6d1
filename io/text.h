// Text that comes from users, made safe for what it goes into.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace toile {

/// `text` with every byte that is not part of well-formed UTF-8, and every control character,
/// replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

/// valid_utf8() with & < > " ' as character references: fit for HTML text and quoted attributes.
std::string html_escaped(std::string_view text);

/// Standard base64 with padding.
std::string base64(std::string_view bytes);

/// `word` as a number, a leading + allowed. Nothing when it is no number. A number that is too
/// small for a double is 0, one that is too large is infinite.
std::optional<double> parse_number(std::string_view word);

/// Appends `value` in the fewest digits that read back to the same bits.
void append_number(std::string& text, double value);

/// A number with `decimals` places, the same in every locale. -0 becomes 0.
std::string fixed_number(double value, int decimals);

}  // namespace toile
