// What dress does once it knows what is asked: reads, dresses, writes and says.
#pragma once

#include "cloth/judge/verdict.h"
#include "tools/dress/settings.h"
#include "tools/program.h"

namespace toile {

/// What became of all layers.
struct DressEnd {
  Verdict verdict;           ///< of the first layer that is not sewn, else sewn
  bool is_certified = true;  ///< false: it was to be certified, and is not
};

/// Dresses all layers, and writes their files and the report. Throws Error for what can't be read,
/// dressed or written.
DressEnd run_dress(const DressSettings& settings, const CommonSettings& common);

/// exit_done for a sewn garment whose states are certified where that was asked, else
/// exit_negative.
ExitCode exit_code_of(const DressEnd& end);

}  // namespace toile
