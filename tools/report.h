// What the reports of all programs have in common.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/output_file.h"
#include "tools/program.h"

namespace toile {

/// JSON as a file's text. Bytes that are no UTF-8, as in names of files, are replaced.
std::string json_text(const nlohmann::ordered_json& json);

/// Writes the file of --report, where it was given. It has `program`, Toile's `version`, the
/// `seconds` since the program began, then the members of `report`, which may have its own seconds.
void write_report(OutputFiles& files, const CommonSettings& common,
                  const nlohmann::ordered_json& report);

}  // namespace toile
