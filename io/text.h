// Text from users made safe for output, and numbers as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace toile {

/// `text` with U+FFFD for every control character and every byte that is not part of well-formed
/// UTF-8.
std::string valid_utf8(std::string_view text);

/// `text` as messages show it: valid_utf8(), cut at 80 bytes.
std::string shown_text(std::string_view text);

/// valid_utf8() with & < > " ' as character references, for HTML text and quoted attributes.
std::string html_escaped(std::string_view text);

/// Standard base64 with padding.
std::string base64(std::string_view bytes);

/// `word` as a number, a leading + allowed. Nothing when it is no number. A number that is too
/// small for a double is 0, one that is too large is infinite.
std::optional<double> parse_number(std::string_view word);

/// Appends `value` in the fewest digits that read back to the same bits.
void append_number(std::string& text, double value);

/// A number with `decimals` decimal places, the same in every locale. -0 becomes 0. This is how
/// reports and messages show numbers to people.
std::string fixed_number(double value, int decimals);

/// A length in metres as people read it: "12.3 cm".
std::string centimetres(double metres, int decimals);

}  // namespace toile
