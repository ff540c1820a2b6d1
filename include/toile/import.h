// Makes a pattern of a drawing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

/// What is said of the pieces. Names are those of the drawing.
struct ImportChoices {
  std::optional<double> metres_per_unit = {};  ///< none: as the drawing says
  std::string size = {};                       ///< of a drawing with several; empty: its base size
  std::optional<double> seam_allowance = {};   ///< metres, taken off cut lines; none: as drawn
  std::vector<std::string> unfold = {};        ///< "PIECE" or "PIECE:EDGE": drawn as a half
  std::vector<std::string> names = {};         ///< "PIECE=NAME": what its panel is called
  std::vector<std::string> pairs = {};         ///< cut as left and right
  std::vector<std::string> singles = {};       ///< cut as one panel
  std::vector<std::string> without = {};       ///< no panel is made of them
  bool cut_line = false;                       ///< bound pieces by cut lines, not by sew lines
};

/// Reads a DXF (AAMA, ASTM) or SVG drawing. A pattern in JSON comes back as it is, or repaired.
/// Throws Error for what can't be read or made a pattern. The same as import-pattern.
TOILE_API SewingPattern import_pattern(const std::filesystem::path& drawing,
                                       const ImportChoices& choices = {});

}  // namespace library
}  // namespace toile
