// The report of import-pattern, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pattern/import/imported_pattern.h"
#include "pattern/import/piece.h"

namespace toile {

/// `format` is "dxf", "svg" or "json"; of a JSON, which is not changed, `pattern` holds no panel.
nlohmann::ordered_json import_pattern_json(const std::string& file, const std::string& format,
                                           const PieceDrawing& drawing,
                                           const ImportedPattern& pattern,
                                           const std::vector<Remark>& remarks);

}  // namespace toile
