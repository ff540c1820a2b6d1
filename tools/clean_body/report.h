// The report of clean-body, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "geometry/body/clean_body.h"

namespace toile {

/// What the largest filled hole has across, in the file's unit; 0 if none was filled.
double largest_hole(const RepairReport& report);

/// `skeleton_given`: the joints were taken from a file, not searched for. `warnings` are those that
/// the user saw.
nlohmann::ordered_json clean_body_json(const CleanBody& body, bool skeleton_given,
                                       const std::vector<std::string>& warnings);

}  // namespace toile
