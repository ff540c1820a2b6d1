// The one exception of the project's own: something that the user gave, or that came of it, cannot
// be used. Programs print what() and end with exit code 1.
#pragma once

#include <charconv>
#include <stdexcept>
#include <string>

namespace toile {

/// `place` says where (a file, "file:line", a panel and edge), `problem` what is wrong there, and
/// `remedy` what the user can do. what() joins them to one line.
class Error : public std::runtime_error {
 public:
  Error(const std::string& place, const std::string& problem, const std::string& remedy)
      : std::runtime_error(place + ": " + problem + (remedy.empty() ? "" : "; " + remedy)) {}
};

/// `value` as an Error's text shows it: rounded to `digits` significant digits, at most 17, without
/// trailing zeros, the same in every locale.
inline std::string number_text(double value, int digits = 4) {
  char text[32];
  return {text,
          std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

}  // namespace toile
