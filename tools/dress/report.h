// The report of dress, as JSON: docs/report.md says what each key is.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cloth/dressing/outfit.h"
#include "tools/dress/method.h"

namespace toile {

/// What the program itself adds to a layer's entry.
struct LayerNotes {
  std::string body;            ///< the file
  std::string standing;        ///< the file of the body before its pose; empty: none
  std::string garment;         ///< the file
  std::string earlier;         ///< the file of the drape to go on from; empty: none
  std::string dressed_sha256;  ///< of the file that holds the drape
  std::vector<Warning> warnings;
  double seconds = 0;  ///< all that the layer took
  /// What took them besides the dressing, in the order in which it was done.
  std::vector<std::pair<std::string, double>> other_seconds;
};

/// All that is measured of one garment.
nlohmann::ordered_json layer_json(const WornLayer& layer, const DressMethod& method,
                                  const LayerNotes& notes);

/// What the judge says of it, a part of that: seams, wraps, openings, intersections, the verdict.
nlohmann::ordered_json judged_json(const WornLayer& layer);

/// Of layers that were relaxed as one: `worn.coupled` is there.
nlohmann::ordered_json coupled_json(const WornOutfit& worn, const std::vector<std::string>& names);

/// How far nodes moved, in millimetres.
nlohmann::ordered_json moved_json(const MoveStatistics& moved);

}  // namespace toile
