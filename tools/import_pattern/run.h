// What import-pattern does once it knows what is asked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pattern/import/dxf_pieces.h"
#include "pattern/import/imported_pattern.h"
#include "tools/program.h"

namespace toile {

struct ImportPatternSettings {
  std::filesystem::path drawing;
  DrawingOptions drawn;
  ImportOptions pieces;
  std::vector<std::string> of_drawings;  ///< options that were given and mean nothing to a JSON
};

/// Reads the drawing and writes the pattern. A GarmentCode JSON is checked and written as
/// it is, or repaired, see repaired_pattern().
/// Returns whether no piece had to be left out. Throws Error for what can't be read or made a
/// pattern.
bool run_import_pattern(const ImportPatternSettings& settings, const CommonSettings& common);

}  // namespace toile
