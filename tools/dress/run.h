// What dress does once it knows what is asked: reads, dresses, writes and says.
#pragma once

#include "cloth/judge/verdict.h"
#include "tools/dress/settings.h"
#include "tools/program.h"

namespace toile {

/// Dresses all layers, writes their files and the report, and gives the verdict of the whole: of
/// the first layer that is not sewn. Throws Error for what can't be read, dressed or written.
Verdict run_dress(const DressSettings& settings, const CommonSettings& common);

/// exit_done for a sewn garment, else exit_negative.
ExitCode exit_code_of(Verdict verdict);

}  // namespace toile
