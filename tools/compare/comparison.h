// Runs side by side, and the best size of each garment on each body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/compare/compared_run.h"

namespace toile {

/// The runs of one garment in one fabric on one body.
struct ComparedRow {
  std::string garment;
  std::string body;
  std::string fabric;
  std::vector<std::size_t> runs;    ///< indices, in the order of Comparison::sizes
  std::optional<std::size_t> best;  ///< a run; none: no size fits
  std::string why;                  ///< what decided
};

struct Comparison {
  std::vector<ComparedRun> runs;
  std::vector<std::string> sizes;  ///< of all runs, the smallest first; "" where none is stated
  std::vector<ComparedRow>
      rows;  ///< in the order of their first runs, those that tell no fabric last
};

/// How the best size is found, in sentences for people.
extern const char* const best_size_rule;

/// Whether a run's size may be the best: it ended well, and is not too small.
bool may_be_best(const ComparedRun& run);

Comparison compare_runs(std::vector<ComparedRun> runs);

/// "-1.2 ± 0.5 cm at the waist"
std::string text_of(const LevelEase& level);

}  // namespace toile
