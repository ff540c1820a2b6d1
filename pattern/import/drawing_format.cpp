#include "pattern/import/drawing_format.h"

#include <array>
#include <utility>

#include "geometry/error.h"
#include "io/dxf.h"

namespace toile {

namespace {

constexpr const char* format_remedy = "give a DXF, an SVG or a GarmentCode JSON";

/// Beginnings of files that people try.
constexpr std::array<std::pair<std::string_view, const char*>, 7> known_beginnings = {{
    {"AC1", "a DWG file; save it as DXF"},
    {"%PDF", "a PDF; export SVG or DXF from the program that made it"},
    {"PK\x03\x04", "a zip archive; unpack it"},
    {"\x89PNG", "a picture; draw the outlines as SVG or DXF"},
    {"\xFF\xD8\xFF", "a picture; draw the outlines as SVG or DXF"},
    {"%!PS", "PostScript; export SVG or DXF from the program that made it"},
    {"\x1F\x8B", "compressed by gzip; unpack it"},
}};

}  // namespace

DrawingFormat drawing_format(std::string_view text, const std::string& name) {
  if (looks_like_dxf(text)) return DrawingFormat::dxf;
  for (const auto& [beginning, what] : known_beginnings) {
    if (text.substr(0, beginning.size()) == beginning) {
      throw Error(name, std::string("is ") + what, "");
    }
  }
  std::string_view rest = text;
  if (rest.substr(0, 3) == "\xEF\xBB\xBF") rest.remove_prefix(3);
  const std::size_t first = rest.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) throw Error(name, "is empty", format_remedy);
  rest.remove_prefix(first);
  if (rest[0] == '{' || rest[0] == '[') return DrawingFormat::json;
  if (rest[0] != '<') throw Error(name, "is neither DXF, SVG nor JSON", format_remedy);
  // Where the root element begins depends on comments and declarations: the name is enough here.
  if (rest.find("<svg") != std::string_view::npos || rest.find(":svg") != std::string_view::npos) {
    return DrawingFormat::svg;
  }
  if (rest.find("<pattern") != std::string_view::npos) {
    throw Error(name, "is a pattern of Valentina or Seamly2D",
                "open it there and export its layout as DXF (AAMA) or SVG");
  }
  throw Error(name, "is XML, but no SVG", format_remedy);
}

}  // namespace toile
