// What a batch came to: its table and its summary.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/batch/manifest.h"

namespace toile {

/// Each row's report, in the order of the rows; null: it is not done yet.
using RowReports = std::vector<nlohmann::ordered_json>;

/// results.csv: a line for every row that is done.
std::string results_csv(const Batch& batch, const RowReports& reports);

/// summary.md, tables in Markdown: how many of each verdict, the causes of what is not sewn, and
/// the seconds. It holds no names of files. All rows are done.
std::string summary_of(const RowReports& reports);

/// Exit code 0 when all rows are sewn, 1 when one could not be done, else 3.
int exit_code_of(const RowReports& reports);

}  // namespace toile
