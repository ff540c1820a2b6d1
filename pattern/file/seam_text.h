// Seams as texts in a drawing: what export-pattern writes and import-pattern reads.
#pragma once

#include <optional>
#include <string>

#include "pattern/pattern.h"

namespace toile {

/// The text in a block that is one panel, and whose turn points are all ends of edges.
inline constexpr const char* drawn_panel_fact = "Panel: as drawn";

/// One side of a seam. Its text stands on the middle of its edge. It runs the way in which the seam
/// is sewn: along both sides from the same end.
struct SeamText {
  int number = 0;                                             ///< of the seam, from 1
  bool second = false;                                        ///< side b of the stitch
  StitchDirection direction = StitchDirection::end_to_start;  ///< by_position: not stated
  bool gathered = false;
  bool layered = false;
  double fullness = 0;  ///< as Stitch has it
};

/// "Seam: 3 a", and behind it "found" where the direction is not stated, "layer", "gather" or
/// "gather 1.5". A seam's name is not kept.
std::string seam_text(const SeamText& seam);

/// Reads that; nothing: it is another text. `direction` is end_to_start or by_position: angles
/// tell.
std::optional<SeamText> read_seam_text(const std::string& text);

}  // namespace toile
