// What batch does once it knows what is asked.
#pragma once

#include <filesystem>

#include "tools/batch/dress_row.h"
#include "tools/batch/manifest.h"
#include "tools/program.h"

namespace toile {

struct BatchSettings {
  Batch batch;
  std::filesystem::path output;  ///< a folder
  std::size_t jobs = 1;          ///< garments at once
  RowLimits limits;
  bool resume = false;  ///< garments that are done already, and of which nothing changed, are kept
};

/// Throws Error when an input lies in the folder that is written.
void refuse_inputs_in(const BatchSettings& settings);

/// Dresses all garments, writes the folder, prints the summary. Gives the exit code. A garment that
/// fails stops no other. Throws Error for files of the batch itself that can't be written.
int run_batch(const BatchSettings& settings, const CommonSettings& common);

}  // namespace toile
