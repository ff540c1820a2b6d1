// The files of a run, known before its work begins.
#pragma once

#include <filesystem>
#include <vector>

namespace toile {

/// All files that a run reads and writes: those that were named, and those beside them.
struct ProgramFiles {
  std::vector<std::filesystem::path> reads;  ///< they may be missing
  std::vector<std::filesystem::path> writes;
  std::vector<std::filesystem::path> keeps;    ///< written for later runs, where that is possible
  std::vector<std::filesystem::path> folders;  ///< filled with any number of files
};

/// Throws Error when a file would be written over one that is read, or over another that is
/// written, by whatever name: see same_file(). A folder that is filled must hold none of them.
void refuse_overwriting(const ProgramFiles& files);

}  // namespace toile
