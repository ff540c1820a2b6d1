// The pieces of a pattern as a drawing has them: what the readers of DXF and SVG make, before
// edges, seams and places are known.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/types.h"
#include "pattern/edge_curve.h"
#include "pattern/file/seam_text.h"
#include "pattern/pattern.h"

namespace toile {

/// Curves that follow each other: each starts where the last one ends. Metres, y up.
using PiecePath = std::vector<EdgeCurve>;

/// A straight line of a drawing. Metres.
struct PieceLine {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
};

/// A mark on an outline that has to meet another one when the pieces are sewn.
struct PieceNotch {
  Vec2 at = Vec2::Zero();       ///< metres, near the outline
  std::optional<double> angle;  ///< radians from +x, counter-clockwise, if the file says it
};

/// A text that says what is sewn to the outline where it stands.
struct PieceSeam {
  SeamText text;
  Vec2 at = Vec2::Zero();  ///< metres
  double angle = 0;        ///< radians from +x: the way in which it is sewn
};

/// One piece as drawn. Metres, y up.
struct Piece {
  std::string name;              ///< as the file has it; may be empty, and need not be unique
  std::string category;          ///< what the file says that it is, in words; empty: not stated
  std::string size;              ///< empty: not stated
  std::string material;          ///< empty: not stated
  int quantity = 1;              ///< how often it is cut
  bool pair = false;             ///< whether half of `quantity` is said to be cut mirrored
  bool none_mirrored = false;    ///< whether the drawing says that none is
  bool is_right_one = false;     ///< of a pair: the right one is drawn, not the left one
  PiecePath outline;             ///< closed: the seam line, or the cut line if that is all there is
  bool is_cut_line = false;      ///< whether `outline` still has the seam allowance
  std::vector<Vec2> corners;     ///< points that the file declares to be corners
  bool has_all_corners = false;  ///< each is one, though the outline may hardly turn there
  std::vector<PieceNotch> notches;
  std::vector<PiecePath> internal_lines;
  std::vector<PiecePath> cut_outs;  ///< closed
  std::vector<Vec2> drill_holes;
  std::vector<PieceSeam> seams;
  /// It is one panel, neither half nor pair, by a program that writes patterns.
  bool is_panel = false;
  bool side_unknown = false;       ///< as PatternPanel has it
  std::string left_out;            ///< as PatternPanel has it
  std::optional<PieceLine> grain;  ///< along the warp
  std::optional<PieceLine> fold;   ///< the piece is half of one that is mirrored about this line
};

/// A piece that no panel can be made of.
struct LeftOutPiece {
  std::string name;  ///< as the file has it
  std::string size;  ///< empty: not stated
  Error error;       ///< what is wrong with it
};

/// What a drawing holds, with the outlines that were understood.
struct PieceDrawing {
  std::string source;     ///< the file it came from, for messages
  std::string unit;       ///< what its unit is taken for, see unit_with_source()
  std::string base_size;  ///< the sample size, if the file states it; else empty
  std::vector<Piece> pieces;
  std::vector<LeftOutPiece> left_out;  ///< of those that were not; `pieces` is not empty
  std::vector<Remark> remarks;
  /// What was not understood: the name of its kind, and how many there were.
  std::map<std::string, int> ignored;
};

}  // namespace toile
