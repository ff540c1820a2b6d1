// The project's exception, and numbers for its text.
#pragma once

#include <charconv>
#include <string>

#include "toile/error.h"

namespace toile {

/// `value` for an Error's text, rounded to `digits` significant digits, without trailing zeros. The
/// text is the same in every locale. `digits` is in [1, 17].
inline std::string number_text(double value, int digits = 4) {
  char text[32];
  return {text,
          std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

}  // namespace toile
