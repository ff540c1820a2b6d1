// What is shown of the results.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/work_precision/study.h"

namespace toile::precision {

struct Results {
  std::vector<Row> rows;
  std::vector<TermRow> terms;
  double presets_mm = 15;  ///< edges at which the presets are compared
  std::string load;        ///< of the machine, at the start
};

/// The presets of `dress --quality` against each other, as Markdown.
std::string presets_table(const Results& results);
/// What cloth/dressing/quality.h says of each preset beside what was measured.
std::string expectations(const Results& results);
/// Error against processor time, log-log, of the garments: SVG.
std::string headline_plot(const Results& results);
/// Everything, as one HTML file that asks for nothing from the network.
std::string page_of(const Results& results);

}  // namespace toile::precision
