// What drape-test does once it knows what is asked.
#pragma once

#include "cloth/fabric_test/drape_tester.h"
#include "cloth/scene/fabric.h"
#include "tools/program.h"

namespace toile {

struct DrapeTestSettings {
  Fabric fabric;
  int starts = 5;
  DrapeTesterSizes sizes;
};

/// Drapes the sheets, says what they do, and draws the first one from the side and from above.
/// Returns exit_negative where a sheet did not come to rest.
ExitCode run_drape_test(const DrapeTestSettings& settings, const CommonSettings& common);

}  // namespace toile
