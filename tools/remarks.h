// Remarks on an input, said and reported.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pattern/pattern.h"
#include "tools/program.h"

namespace toile {

/// A line on stderr for each: warnings always, notes unless -q.
void say_remarks(const std::vector<Remark>& remarks, const CommonSettings& common);

/// The text of those that are warnings.
std::vector<std::string> warnings_in(const std::vector<Remark>& remarks);

/// Adds the lists `notes` and `warnings` to a report.
void add_remarks(const std::vector<Remark>& remarks, nlohmann::ordered_json& report);

}  // namespace toile
