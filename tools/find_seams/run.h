// Finds the seams of a pattern file and writes them into a copy of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/program.h"

namespace toile {

struct FindSeamsSettings {
  std::filesystem::path pattern;
  bool keep = false;                 ///< the stitches of the file stay
  bool by_place = false;             ///< see FindSeamsOptions
  double min_confidence = 0;         ///< 0 to 1: a less certain seam is not sewn
  std::vector<std::string> with;     ///< panels to take in that are no pieces of the shell
  std::vector<std::string> without;  ///< panels to leave out
  std::vector<std::string> sewn;     ///< "front:3 back:1", given on the command line
};

/// Returns exit_negative when a seam is undecided; the file is written nevertheless. Throws Error
/// for bad input.
int run_find_seams(const FindSeamsSettings& settings, const CommonSettings& common);

}  // namespace toile
