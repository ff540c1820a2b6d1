// The report of clean-body, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "geometry/body/clean_body.h"

namespace toile {

/// `skeleton_given`: the joints were taken from a file, not searched for.
nlohmann::ordered_json clean_body_json(const CleanBody& body, bool skeleton_given);

}  // namespace toile
