#include <algorithm>
#include <cstdint>
#include <set>

#include "geometry/angles.h"
#include "io/sheet.h"
#include "io/text.h"

namespace toile {

namespace {

/// Metres that chords leave curves by. Half of it makes 1.4 times as many points, and double of it
/// curves of a tenth more parts when they are read again.
constexpr double chord_error = 1e-6;

/// Appends a character of UTF-8 as ASCII, and goes past it.
void append_ascii(std::string& ascii, const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  if (first < 0x80) {
    ascii += text[at++];
    return;
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = code << 6U | (byte(at + i) & 0x3FU);
  at += length;
  // Four digits are all that there are: what lies beyond is a question mark.
  static constexpr char digits[] = "0123456789ABCDEF";
  if (code > 0xFFFF) {
    ascii += '?';
    return;
  }
  ascii += "\\U+";
  for (int shift = 12; shift >= 0; shift -= 4) ascii += digits[code >> shift & 0xFU];
}

std::string in_ascii(const std::string& text) {
  const std::string valid = valid_utf8(text);
  std::string ascii;
  for (std::size_t at = 0; at < valid.size();) append_ascii(ascii, valid, at);
  return ascii;
}

class DxfWriter {
 public:
  explicit DxfWriter(const Sheet& sheet) : sheet_(sheet) {}

  std::string write() {
    const std::vector<std::string> names = block_names();
    header();
    tables();
    section("BLOCKS");
    for (std::size_t i = 0; i < names.size(); ++i) block(sheet_.parts[i], names[i]);
    code(0, "ENDSEC");
    section("ENTITIES");
    for (const std::string& name : names) {
      entity("INSERT", 1);
      code(2, name);
      point({0, 0});
    }
    for (std::size_t i = 0; i < sheet_.facts.size(); ++i) {
      text({sheet_.facts[i], Vec2(4e-3, 4e-3 + 6e-3 * static_cast<double>(i)), 4e-3, 0}, 1, false);
    }
    code(0, "ENDSEC");
    code(0, "EOF");
    return std::move(text_);
  }

 private:
  void code(int number, const std::string& value) {
    const std::string digits = std::to_string(number);
    text_.append(3 - std::min<std::size_t>(3, digits.size()), ' ');
    text_ += digits + "\n" + value + "\n";
  }
  void millimetres(int number, double metres) { code(number, fixed_number(metres * 1000, 5)); }
  void point(const Vec2& at, int first = 10) {
    millimetres(first, at.x());
    millimetres(first + 10, at.y());
    millimetres(first + 20, 0);
  }
  void section(const std::string& name) {
    code(0, "SECTION");
    code(2, name);
  }
  void entity(const std::string& type, int layer) {
    code(0, type);
    code(8, std::to_string(layer));
  }

  void header() {
    section("HEADER");
    code(9, "$ACADVER");
    code(1, "AC1009");
    // Millimetres: the text "METRIC" of a small garment may be taken for centimetres.
    code(9, "$INSUNITS");
    code(70, "4");
    code(9, "$EXTMIN");
    point({0, 0});
    code(9, "$EXTMAX");
    point(sheet_.size);
    code(0, "ENDSEC");
  }

  void tables() {
    std::set<int> layers = {0, 1, 2, 3, 15};
    for (const SheetStyle& style : sheet_.styles) layers.insert(style.layer);
    for (const SheetPart& part : sheet_.parts) {
      for (const SheetMark& mark : part.marks) layers.insert(mark.layer);
    }
    section("TABLES");
    table("LTYPE", 1);
    code(0, "LTYPE");
    code(2, "CONTINUOUS");
    code(70, "0");
    code(3, "Solid line");
    code(72, "65");
    code(73, "0");
    code(40, "0.0");
    code(0, "ENDTAB");
    table("LAYER", layers.size());
    for (const int layer : layers) {
      code(0, "LAYER");
      code(2, std::to_string(layer));
      code(70, "0");
      code(62, "7");
      code(6, "CONTINUOUS");
    }
    code(0, "ENDTAB");
    table("STYLE", 1);
    code(0, "STYLE");
    code(2, "STANDARD");
    code(70, "0");
    code(40, "0.0");
    code(41, "1.0");
    code(50, "0.0");
    code(71, "0");
    code(42, "2.5");
    code(3, "txt");
    code(4, "");
    code(0, "ENDTAB");
    code(0, "ENDSEC");
  }
  void table(const std::string& name, std::size_t count) {
    code(0, "TABLE");
    code(2, name);
    code(70, std::to_string(count));
  }

  /// Names of blocks in R12: 31 characters, capitals, digits and three signs. None twice.
  std::vector<std::string> block_names() const {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const SheetPart& part : sheet_.parts) {
      std::string name;
      for (const char c : part.name) {
        const bool letter = c >= 'a' && c <= 'z';
        const bool kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        name += letter ? static_cast<char>(c - 'a' + 'A') : kept ? c : '_';
      }
      if (name.empty()) name = "PIECE";
      name.resize(std::min<std::size_t>(name.size(), 26));
      std::string unique = name;
      for (int i = 2; !taken.insert(unique).second; ++i) unique = name + "_" + std::to_string(i);
      names.push_back(unique);
    }
    return names;
  }

  void block(const SheetPart& part, const std::string& name) {
    entity("BLOCK", 1);
    code(2, name);
    code(70, "0");
    point({0, 0});
    code(3, name);
    Vec2 first = Vec2::Zero();
    if (!part.paths.empty()) first = part.paths[0].path.start;
    for (const std::string& fact : part.facts) text({fact, first, 4e-3, 0}, 1, false);
    for (const SheetPath& path : part.paths) polyline(path);
    for (const SheetMark& mark : part.marks) {
      entity("POINT", mark.layer);
      point(mark.at);
      if (mark.angle) code(50, fixed_number(to_degrees(*mark.angle), 4));
    }
    for (const SheetText& one : part.data) text(one, 15, false);
    for (const SheetText& one : part.texts) text(one, 15, true);
    entity("ENDBLK", 1);
  }

  void polyline(const SheetPath& path) {
    const int layer = sheet_.styles[static_cast<std::size_t>(path.style)].layer;
    std::vector<Vec2> points = path_vertices(path.path, chord_error);
    if (path.path.closed) points.pop_back();
    if (points.size() == 2) {
      entity("LINE", layer);
      point(points[0]);
      point(points[1], 11);
      return;
    }
    entity("POLYLINE", layer);
    code(66, "1");
    point({0, 0});
    code(70, path.path.closed ? "1" : "0");
    for (const Vec2& at : points) {
      entity("VERTEX", layer);
      point(at);
    }
    entity("SEQEND", layer);
    // Layer 3 says which points of a boundary lie on a curve.
    if (layer != 1 && layer != 14) return;
    std::size_t i = 0;
    for (const DrawnSegment& segment : path.path.segments) {
      for (++i; i < points.size() && points[i] != segment.end; ++i) {
        entity("POINT", 3);
        point(points[i]);
      }
    }
  }

  /// A text in its middle, or one that starts at its place.
  void text(const SheetText& one, int layer, bool centred) {
    entity("TEXT", layer);
    point(one.at);
    millimetres(40, one.height);
    code(1, in_ascii(one.text));
    if (one.angle != 0) code(50, fixed_number(to_degrees(one.angle), 4));
    if (!centred) return;
    code(72, "1");
    code(73, "2");
    point(one.at, 11);
  }

  const Sheet& sheet_;
  std::string text_;
};

}  // namespace

std::string sheet_dxf(const Sheet& sheet) { return DxfWriter(sheet).write(); }

}  // namespace toile
