// Landmarks as JSON, the same in body.body.json and in measures.json.
#pragma once

#include <nlohmann/json.hpp>

#include "geometry/body/landmark.h"

namespace toile {

/// {name: {"place_m": [x, y, z] or null, "confidence": 0 to 1, "reason": text if there is one}}.
nlohmann::ordered_json landmarks_json(const Landmarks& landmarks);

}  // namespace toile
