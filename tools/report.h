// What the reports of all programs have in common.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cloth/judge/fit.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "io/warning.h"
#include "tools/program.h"

namespace toile {

/// JSON as a file's text. Bytes that are no UTF-8, as in names of files, are replaced.
std::string json_text(const nlohmann::ordered_json& json);

/// Warnings as a report's list of `code`, `place` and `text`.
nlohmann::ordered_json warnings_json(const std::vector<Warning>& warnings);

/// The `warnings` of a report that a program wrote. Throws Error where they are none.
std::vector<Warning> read_warnings(const JsonValue& report);

/// Texts as warnings of one `code` that are about the whole.
std::vector<Warning> warnings_of(const std::string& code, const std::vector<std::string>& texts);

/// Fit as a report's `verdict` and `levels`. `panels` are the garment's names.
nlohmann::ordered_json fit_json(const Fit& fit, const std::string& verdict,
                                const std::vector<std::string>& panels);

/// Names of panels, as valid UTF-8.
nlohmann::ordered_json names_json(const std::vector<int>& panels,
                                  const std::vector<std::string>& names);

/// "verdict: sewn; fit: ok". Of what crosses the fit comes first: cloth may cross because it is cut
/// too small.
std::string verdict_line(const std::string& verdict, const std::string& fit);

/// The text of a report. It has `program`, Toile's `version`, the `seconds` since the program
/// began, then the members of `report`, which may have its own seconds.
std::string report_text(const CommonSettings& common, const nlohmann::ordered_json& report);
/// Writes it to the file of --report, where that was given.
void write_report(OutputFiles& files, const CommonSettings& common,
                  const nlohmann::ordered_json& report);

}  // namespace toile
