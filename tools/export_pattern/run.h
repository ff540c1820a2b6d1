// What export-pattern does once it knows what is asked.
#pragma once

#include <filesystem>

#include "pattern/export/pattern_sheet.h"
#include "tools/program.h"

namespace toile {

struct ExportPatternSettings {
  std::filesystem::path pattern;
  PatternSheetOptions sheet;
};

/// Writes the pattern as the output's extension says: .svg, .dxf or .pdf. Throws Error for a
/// pattern that can't be read and for a sheet that is too large for a page of PDF.
void run_export_pattern(const ExportPatternSettings& settings, const CommonSettings& common);

}  // namespace toile
