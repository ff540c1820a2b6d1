// The project's exception: the user's input, or a result of it, cannot be used. Programs print
// what() and end with exit code 1.
#pragma once

#include <charconv>
#include <stdexcept>
#include <string>

namespace toile {

/// `place` names a file, "file:line", or a panel and edge. `problem` says what is wrong there.
/// `remedy` says what the user can do; it may be empty. what() joins the three to one line.
class Error : public std::runtime_error {
 public:
  Error(const std::string& place, const std::string& problem, const std::string& remedy)
      : std::runtime_error(place + ": " + problem + (remedy.empty() ? "" : "; " + remedy)) {}
};

/// `value` for an Error's text, rounded to `digits` significant digits, without trailing zeros. The
/// text is the same in every locale. `digits` is in [1, 17].
inline std::string number_text(double value, int digits = 4) {
  char text[32];
  return {text,
          std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

}  // namespace toile
