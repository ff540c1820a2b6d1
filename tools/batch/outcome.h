// What a batch's table says of a garment, from the report of dress or from a message.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace toile {

/// The verdict of a garment that could not be done.
inline constexpr const char* error_verdict = "error";

/// All verdicts of garments, from sewn on; the error is the last.
std::vector<std::string> verdicts_in_order();

/// The keys `verdict`, `cause`, `detail`, `figures` and `warnings` of a garment's report. `cause`
/// is the same for garments that fail alike; `detail` names what failed. Both are empty for a sewn
/// one. Throws Error when `file` does not hold a report of dress.
nlohmann::ordered_json outcome_of(const std::string& dress_report, const std::string& file);

/// The same keys of a garment that could not be done. `program` failed with `message`.
nlohmann::ordered_json failure(const std::string& program, const std::string& message);

/// Adds `bust_ease_cm`, `waist_ease_cm` and `hip_ease_cm`, as cut, to a garment's figures. They are
/// null where the report of ease-map has no such level. Throws Error when it is no such report.
void add_girth_ease(const std::string& ease_report, const std::string& file,
                    nlohmann::ordered_json& figures);

}  // namespace toile
