// A comparison as files: a page, a table, a report.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/compare/comparison.h"

namespace toile {

/// A page without scripts: a row for each garment, body and fabric, and a column for each size. Its
/// links count from the folder of `page`.
std::string comparison_page(const Comparison& comparison, const std::filesystem::path& page);

/// A line a run, as the page has them: garment, body, fabric, size, verdict, fit, worst_level,
/// worst_ease_cm, plus_minus_ease_cm, target, off_level, off_cm, best, why, page, report.
std::string comparison_csv(const Comparison& comparison);

/// The same as a report's `rule`, `runs` and `best`.
nlohmann::ordered_json comparison_json(const Comparison& comparison);

/// A line a row: "tshirt on mannequin in jersey: 38, worst ease ...".
std::vector<std::string> comparison_lines(const Comparison& comparison);

}  // namespace toile
