// A pattern made of the pieces of a drawing, in GarmentCode's JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "pattern/import/outline_edges.h"
#include "pattern/import/piece.h"

namespace toile {

/// What the user says about the pieces.
struct ImportOptions {
  std::string size;                      ///< of a drawing with several; empty: the base size
  std::optional<double> seam_allowance;  ///< metres: taken off cut lines; nothing: as drawn
  /// "PIECE" or "PIECE:EDGE": halves without a mark of their fold. EDGE is that of the half, with
  /// its seam allowance; without EDGE, it is likely_fold().
  std::vector<std::string> unfold;
  std::vector<std::string> names;  ///< "PIECE=NAME": what its panel is called instead
  std::vector<std::string> pairs;  ///< pieces that are cut as a pair, though the file does not say
  std::vector<std::string> singles;  ///< pieces that are no pair, see cut_as()
  std::vector<std::string> without;  ///< pieces that no panel is wanted of
  EdgeOptions edges;
};

/// A side of a seam that the drawing states.
struct SeamSide {
  SeamText text;
  int edge = 0;
  bool forward = true;  ///< it is sewn from the start of its edge on
};

/// A panel of the pattern. Metres, y up.
struct ImportedPanel {
  std::string name;   ///< unique, and one that read_pattern() takes
  std::string piece;  ///< as the drawing has it
  std::string asked;  ///< the name that options have for its piece
  EdgedOutline outline;
  std::vector<std::vector<Vec2>> internal_lines;
  std::vector<std::vector<Vec2>> cut_outs;  ///< closed, the first point not repeated
  std::vector<Vec2> drill_holes;
  std::optional<double> grain;  ///< radians counter-clockwise from +y to the warp, within a quarter
  std::string material;
  std::string fabric;  ///< one that dress knows by name; empty: the garment's
  int quantity = 1;
  bool is_unfolded = false;        ///< drawn as a half
  bool is_of_pair = false;         ///< one of a left and a right one, drawn once
  std::optional<int> likely_fold;  ///< of one that is taken as whole: likely_fold() of its piece
  bool is_symmetric = false;       ///< its own mirror image, along the grain or across
  std::vector<SeamSide> seams;     ///< of a piece that is a panel
  std::string left_out;            ///< as PatternPanel has it
  double area = 0;                 ///< square metres
  double turned = 0;               ///< radians, counter-clockwise about the drawing's origin
  Vec2 moved = Vec2::Zero();       ///< metres, after the turn, from where the drawing has it
};

/// A seam between two edges.
struct ImportedSeam {
  int panel_a = 0;
  int edge_a = 0;
  int panel_b = 0;
  int edge_b = 0;
  bool end_to_start = true;  ///< else they run side by side
  SeamText text;             ///< of side a
};

/// All panels, and what was remarked on the way.
struct ImportedPattern {
  std::string size;                ///< the one that was taken; empty: the drawing states none
  std::vector<std::string> sizes;  ///< all that the drawing has
  std::vector<ImportedPanel> panels;
  std::vector<ImportedSeam> seams;     ///< that the drawing states
  std::vector<LeftOutPiece> left_out;  ///< pieces of this size that can't be panels, not asked for
};

/// Makes the panels: of the size asked for, half pieces unfolded, pairs as left_NAME, as drawn, and
/// right_NAME, mirrored, or the other way round (Piece::is_right_one). cut_as() tells pairs.
///
/// Options name a piece as its panel is named without `unfold`, `names`, `pairs` and `singles`. A
/// pair of the drawing is named without left_ and right_. Remarks name pieces that look like
/// halves.
///
/// Panels are turned as upright_turns() says, each with its own marks. They stay where that puts
/// them, unless the boxes of two overlap. Then all are laid out side by side. Remarks of the
/// drawing and what it ignored are added to `remarks`.
///
/// A piece for which shape_of(), unfolded_shape() of a drawn fold, without_allowance() or
/// edges_of() throws is left out, with a warning.
///
/// Throws Error, naming the piece, if none is left. It throws it for sizes and pieces that are not
/// there, for those that cannot be unfolded as asked, and beyond max_panels.
ImportedPattern import_pieces(const PieceDrawing& drawing, const ImportOptions& options,
                              std::vector<Remark>& remarks);

/// The pattern as GarmentCode's JSON: in centimetres, without places and rotations. Edges
/// run counter-clockwise, so seams run from end to start (normalized_edge_loops).
nlohmann::ordered_json pattern_json(const ImportedPattern& pattern);

/// JSON as a person reads it: short lists and objects in one line.
std::string readable_json(const nlohmann::ordered_json& json);

}  // namespace toile
