// Reads SVG drawings: what is drawn, where, and how it is named. It knows no meaning.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/error.h"
#include "geometry/types.h"
#include "io/drawn_path.h"

namespace toile {

/// A group of elements; a layer of Inkscape is one.
struct SvgGroup {
  int parent = -1;  ///< index into SvgDrawing::groups; -1: none
  std::string id;
  std::string label;  ///< inkscape:label
  std::string title;  ///< the text of a <title>
  std::vector<std::string> classes;
};

/// A `use` of another element.
struct SvgUse {
  std::string target;         ///< the id that it draws
  Vec2 at = Vec2::Zero();     ///< where the origin of what it draws comes to be
  Vec2 right = Vec2::Zero();  ///< where the direction (1, 0) of what it draws points to
  int group = -1;             ///< the group that it is in
};

/// A drawn element.
struct SvgShape {
  std::string element;  ///< path, rect, circle, ellipse, line, polyline or polygon
  std::string id;
  std::string label;  ///< inkscape:label
  std::string title;
  std::vector<std::string> classes;
  std::string marker_start;  ///< id of the marker; empty: none
  std::string marker_end;
  int group = -1;  ///< the innermost group that it is in; -1: none
  int use = -1;    ///< index into SvgDrawing::uses of the outermost `use` that draws it; -1: none
  int line = 0;    ///< of the file
  std::vector<DrawnPath> paths;
  /// What can't be read of its path or its points. Its paths are empty then.
  std::optional<Error> unreadable;
};

/// A line of text.
struct SvgText {
  std::string text;  ///< blanks are single, none at the ends
  Vec2 at = Vec2::Zero();
  std::string on_path;  ///< id of the element along which it runs; empty: none
  std::vector<std::string> classes;
  int group = -1;
};

/// All that is drawn and not hidden, in the order of the file. Coordinates are user units of the
/// outermost element, y down.
struct SvgDrawing {
  std::vector<SvgGroup> groups;
  std::vector<SvgShape> shapes;
  std::vector<SvgText> texts;
  std::vector<SvgUse> uses;
  std::vector<std::string> namespaces;  ///< those that the outermost element declares
  /// Metres of one user unit, across and down, by width, height and viewBox; pixels have 96 an
  /// inch.
  Vec2 metres_per_unit = Vec2::Zero();
  /// Whether width or height are stated in a unit of length and not in pixels.
  bool physical = false;
  std::map<std::string, int> ignored;  ///< elements that are not read, by name
};

/// Reads an SVG drawing. Transforms, nested <svg>, <use>, <symbol> and view boxes are worked in.
/// Rules of a <style> are read that hide elements by name, id or class.
///
/// What <defs>, <clipPath>, <mask>, <marker>, <pattern> and <symbol> hold is drawn where it is used
/// only. Entities that the file declares are not replaced. Nothing is fetched, and nothing is run.
///
/// Throws Error with line and element for malformed XML and for values that can't be read. What
/// can't be read of a path or polygon is kept in its shape: it may be a mark that nobody needs.
/// Throws Error for coordinates beyond max_coordinate and for a `use` that draws itself. Throws it
/// beyond max_svg_bytes, max_svg_depth and max_svg_elements, copies by `use` counted.
SvgDrawing parse_svg(std::string_view text, const std::string& name);

inline constexpr std::size_t max_svg_bytes = 256U << 20U;
inline constexpr int max_svg_depth = 200;
inline constexpr int max_svg_elements = 500'000;

}  // namespace toile
