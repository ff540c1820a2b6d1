// What find-seams reports.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pattern/pattern.h"
#include "pattern/seams/split_search.h"

namespace toile {

/// A panel that was taken out of the pattern before seams were looked for.
struct LeftOut {
  std::string name;
  std::string kind;  ///< why: what it is, or "asked for"
};

/// "front:3", as --sew takes it.
std::string side_name(const Pattern& pattern, const EdgeRef& side);

/// The edges in no seam, decided or not: hems, necklines and cuffs among them.
std::vector<EdgeRef> open_edges(const Pattern& pattern, const FoundSeams& found);

/// The report, lengths in centimetres.
nlohmann::ordered_json find_seams_json(const std::string& file, const SplitSeams& split,
                                       const std::vector<LeftOut>& left_out, double min_confidence,
                                       const std::vector<Remark>& remarks);

}  // namespace toile
