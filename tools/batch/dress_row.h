// One garment of a batch, from its pattern to its report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/warning.h"
#include "tools/batch/files.h"
#include "tools/batch/manifest.h"

namespace toile {

/// What all garments of a batch have in common.
struct RowLimits {
  /// To mesh and dress a garment; then for its tables and pictures; and to clean a body.
  std::optional<double> seconds;
  std::optional<std::uint64_t> memory;  ///< bytes of addresses, of each program
  int threads = 1;                      ///< of each program
  bool pictures = true;                 ///< false: no page and no pictures
};

/// A body that was cleaned, or why it could not be.
struct CleanedBody {
  std::filesystem::path file;
  std::string problem;                 ///< empty: the file is there
  std::vector<Warning> warnings = {};  ///< that clean-body said
  bool is_usable = true;               ///< false: it is not there, or can't be relied on
};

/// Cleans a body by the program, within the limits of a garment. `problem` says why not. What the
/// program says goes to `BODY.log.txt` and `BODY.report.json` beside `output`.
CleanedBody clean_body_of_batch(const std::filesystem::path& body,
                                const std::filesystem::path& output, const RowLimits& limits);

/// Meshes, dresses, measures and draws the garment by the programs, each a process of its own. The
/// folder must hold no file of an earlier run. Gives what `report.json` says of how it went; what
/// fails is said there.
nlohmann::ordered_json dress_row(const BatchRow& row, const CleanedBody& body,
                                 const GarmentFiles& files, const RowLimits& limits);

}  // namespace toile
