// The closed paths of an SVG drawing: how they lie in each other, and which bound pieces.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "io/svg.h"
#include "pattern/import/drawing_options.h"
#include "pattern/import/piece.h"
#include "pattern/import/svg_roles.h"

namespace toile {

/// Metres that chords leave curves by, where only the place of a path is asked for.
inline constexpr double place_tolerance = 1e-4;

/// Square metres: no piece of a garment is smaller than 2 cm by 2 cm.
inline constexpr double smallest_piece = 4e-4;

/// A drawing, and what was made of it so far.
struct SvgSheet {
  SvgDrawing drawing;
  DrawingOptions options;
  Vec2 scale = Vec2::Zero();         ///< metres per unit of the drawing
  std::vector<SvgMeaning> meanings;  ///< of each shape
  PieceDrawing pieces;               ///< its source, remarks and ignored are written to

  void note(const std::string& text, bool warning = false);
  void ignore(const std::string& what) { ++pieces.ignored[what]; }
  /// Metres, y up, of a point of the drawing.
  Vec2 metres(const Vec2& point) const { return {point.x() * scale.x(), -point.y() * scale.y()}; }
  /// A point in metres, in the drawing's numbers.
  std::string where(const Vec2& point) const;
  /// The part of FreeSewing that holds a group; -1: none.
  int part_of(int group) const;
};

/// A closed path of a drawing.
struct SvgOutline {
  PiecePath path;
  std::vector<Vec2> polygon;
  Eigen::AlignedBox2d box;
  double area = 0;
  int shape = 0;  ///< index into SvgDrawing::shapes of its first curve
  SvgMeaning meaning;
  int part = -1;          ///< FreeSewing's part
  int around = -1;        ///< index of the smallest outline that it lies in; -1: none
  bool of_piece = false;  ///< the seam line of a piece, or its cut line
};

/// An open path of a drawing.
struct SvgLine {
  PiecePath path;
  int shape = 0;  ///< index into SvgDrawing::shapes of its first curve
};

struct SvgOutlines {
  /// An outline that is a piece.
  struct Chosen {
    int outline = 0;  ///< index into `all`
    bool is_cut_line = false;
  };
  bool classed = false;  ///< outlines are told by their classes
  std::vector<SvgOutline> all;
  std::vector<Chosen> chosen;  ///< one or more, in the order of the file
  std::vector<SvgLine> open;
  std::vector<int> marked_lines;   ///< shapes that are a grain or a fold
  std::vector<int> marked_points;  ///< shapes that are notches or drill holes
};

/// Sorts the shapes of a drawing by what they mean, joins loose lines, and chooses the outlines of
/// pieces. Writes the meanings. Throws Error as svg_pieces() does for outlines. O(n^2) of the
/// closed paths, which are 20,000 at most.
SvgOutlines find_outlines(SvgSheet& sheet);

/// Metres.
double distance_to_polygon(const std::vector<Vec2>& polygon, const Vec2& point);

/// `count` points at equal steps along chords, a closed path's with the one back to its start.
std::vector<Vec2> spread_points(std::vector<Vec2> chords, int count, bool closed);

/// Whether all of a path lies inside of the outline or, within the gap that is closed, on it.
bool holds(const SvgOutline& outline, const std::vector<Vec2>& points);

}  // namespace toile
