// A drawing of named parts at scale, as SVG, DXF and PDF show it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "io/drawn_path.h"

namespace toile {

/// How the lines of one kind look, and how the formats name the kind.
struct SheetStyle {
  std::string css_class;  ///< in SVG; empty: such lines are in DXF only
  int layer = 0;          ///< in DXF
  double width = 0;       ///< metres
  bool dashed = false;
  bool arrows = false;  ///< a head at both ends
};

struct SheetPath {
  int style = 0;  ///< index into Sheet::styles
  DrawnPath path;
};

/// A point with a sign for it.
struct SheetMark {
  enum class Sign {
    notch,  ///< a short line from the point
    hole,   ///< a small cross
    none,   ///< drawn in DXF only
  };
  Sign sign = Sign::none;
  int layer = 0;  ///< in DXF
  Vec2 at = Vec2::Zero();
  std::optional<double> angle;  ///< radians counter-clockwise from +x
};

struct SheetText {
  std::string text;
  Vec2 at = Vec2::Zero();  ///< metres: the middle of the text
  double height = 0;       ///< metres: of the font
  double angle = 0;        ///< radians counter-clockwise
};

/// What belongs together.
struct SheetPart {
  std::string name;
  std::vector<SheetPath> paths;
  std::vector<SheetMark> marks;
  std::vector<SheetText> texts;    ///< to be seen
  std::vector<std::string> facts;  ///< "Quantity: 2": texts for programs, in DXF
  std::vector<SheetText> data;     ///< the same with a place, in DXF on layer 15
};

/// A drawing from (0, 0) to `size`. Metres, y up.
struct Sheet {
  std::string title;
  Vec2 size = Vec2::Zero();
  std::vector<SheetStyle> styles;
  std::vector<SheetPart> parts;
  std::vector<std::string> facts;  ///< of the whole drawing: texts for programs, in DXF
  /// Where a line of 10 cm starts by which prints are checked; nothing: there is none.
  std::optional<Vec2> scale_bar;
};

/// Metres.
inline constexpr double scale_bar_length = 0.1;
/// Metres: the line of a notch.
inline constexpr double notch_length = 5e-3;

/// An SVG file: millimetres, a group for each part, labelled with its name. Curves stay curves.
std::string sheet_svg(const Sheet& sheet);

/// A DXF file of version R12: millimetres, a block for each part, inserted once. Curves become
/// chords within 0.001 mm. Characters beyond ASCII are written as \U+XXXX.
std::string sheet_dxf(const Sheet& sheet);

/// A PDF file of one page at scale. The same input gives the same bytes with the same version of
/// cairo. Throws Error for a sheet that is longer than the 5.08 m that a page may be.
std::string sheet_pdf(const Sheet& sheet);

}  // namespace toile
