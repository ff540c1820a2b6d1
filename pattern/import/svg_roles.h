// What the shapes and texts of an SVG mean on a pattern: by FreeSewing's classes and markers, and
// by words in names.
#pragma once

#include <optional>
#include <string>

#include "io/svg.h"
#include "pattern/import/piece_text.h"

namespace toile {

/// What a shape of a pattern is.
enum class SvgRole {
  unknown,    ///< an outline or an internal line, by where it lies
  outline,    ///< a seam line, by its class
  allowance,  ///< a cut line, outside of a seam line
  grain,
  fold,
  notch,
  drill_hole,
  cut_out,
  remark,  ///< drawn for people: dimensions, scale boxes, help lines
  unseen,  ///< FreeSewing's own style sheet hides it
};

struct SvgMeaning {
  SvgRole role = SvgRole::unknown;
  std::string what;      ///< of a remark: its kind, for PieceDrawing::ignored
  std::string material;  ///< of an outline and an allowance, by their class; may be empty
};

/// Whether FreeSewing made the drawing.
bool is_freesewing(const SvgDrawing& drawing);

/// The index of FreeSewing's group of one part, by a group in it; -1: it is in none.
int freesewing_part(const SvgDrawing& drawing, int group);
/// The name of a part: "front" of the group "fs-stack-teagan.front-part-teagan.front".
std::string freesewing_part_name(const SvgGroup& part);

/// By class, markers, the element that a `use` draws, and words in names. In drawings that are not
/// FreeSewing's, the class names of materials count all the same.
SvgMeaning meaning_of(const SvgDrawing& drawing, const SvgShape& shape);

/// Whether FreeSewing's class says that the shape is a mark or a note, such as that of a measure.
bool is_freesewing_mark(const SvgShape& shape);

/// What a text says about cutting.
struct CuttingText {
  PieceQuantity quantity;
  bool on_fold = false;
  std::string material;  ///< empty: not stated
};

/// Each "Cut 2 mirrored from fabric" or "Cut 1 on the fold" of a text, in its order. FreeSewing
/// puts all that is cut of a part into one text, in words or in keys of its translations.
std::vector<CuttingText> read_cuttings(const std::string& text);

/// Whether an editor gave the id, as in "path1234".
bool is_automatic_id(const std::string& id);

}  // namespace toile
