// Reads numbers and letters from the values of SVG attributes. Its errors name the element.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace toile {

/// Reads a value from its start to its end. Blanks and commas between numbers are passed over. The
/// text has to outlive it. Every Error has the given place.
class SvgScanner {
 public:
  SvgScanner(std::string_view text, std::string place) : text_(text), place_(std::move(place)) {}

  /// Whether nothing but blanks and commas is left.
  bool at_end();
  /// Whether a number follows.
  bool at_number();
  /// A finite number; a number may end where the next one begins, as in "1-2" and "1.5.5".
  double number();
  /// 0 or 1, which may stand next to the number after it.
  bool flag();
  /// The next character, whatever it is; 0 at the end.
  char letter();
  /// The letters of a name that follows; may be empty.
  std::string_view word();
  /// Throws Error, with the column where the value can't be read.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void skip();

  std::string_view text_;
  std::string place_;
  std::size_t at_ = 0;
};

/// A length in user units, of which an inch has 96 and an em 16. `whole` is what 100 % are. Throws
/// Error for what is no length.
double svg_length(std::string_view text, double whole, const std::string& place);

/// Metres of a length that has a unit of its own: mm, cm, in, pt, pc or Q. Nothing for px, for
/// other units and for a bare number.
std::optional<double> svg_physical_length(std::string_view text);

}  // namespace toile
