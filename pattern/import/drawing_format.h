// What kind of file a pattern comes in.
#pragma once

#include <string>
#include <string_view>

namespace toile {

/// Files that patterns are imported from.
enum class DrawingFormat { dxf, svg, json };

/// Tells the format by the content: names are often wrong. Throws Error with the place `name` for
/// what is none of them, and says what it is where that is known.
DrawingFormat drawing_format(std::string_view text, const std::string& name);

}  // namespace toile
