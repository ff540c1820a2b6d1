// Finds the seams of a pattern file and writes them into a copy of it.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/find_seams/report.h"
#include "tools/program.h"

namespace toile {

struct FindSeamsSettings {
  std::filesystem::path pattern;
  bool keep = false;                 ///< the stitches of the file stay
  bool by_place = false;             ///< see FindSeamsOptions
  double min_confidence = 0;         ///< 0 to 1: a less certain seam is not sewn
  double time_limit = 0;             ///< seconds after which the best so far is taken; 0: none
  std::vector<std::string> with;     ///< panels to take in that are no pieces of the shell
  std::vector<std::string> without;  ///< panels to leave out
  std::vector<std::string> sewn;     ///< "front:3 back:1", given on the command line
};

/// --sew, --with, --min-confidence and --time-limit.
void add_seam_options(boost::program_options::options_description& options);
/// Reads them. Throws UsageError for a value that an option can't take.
void read_seam_options(const boost::program_options::variables_map& given,
                       FindSeamsSettings& settings);

/// A seam that was not sure enough to be sewn.
struct UndecidedSeam {
  std::string name;  ///< "front:3 back:1", edges as the written pattern has them
  double confidence = 0;
};

/// What became of the edges.
struct FindSeamsEnd {
  std::vector<UndecidedSeam> undecided;
  std::vector<LeftOut> left_out;
};

/// A pattern with its seams, undecided or not.
struct SewnPattern {
  std::string text;  ///< of its file
  SplitSeams found;
  std::vector<Remark> remarks;
  FindSeamsEnd end;
};

/// Finds the seams of the pattern of a file's `text`; `name` stands for the file in messages. Says
/// how far it is. Throws Error for bad input.
SewnPattern sew_pattern(std::string text, const std::string& name,
                        const FindSeamsSettings& settings, const CommonSettings& common);

/// Writes the pattern with its seams, undecided or not. Throws Error for bad input.
FindSeamsEnd run_find_seams(const FindSeamsSettings& settings, const CommonSettings& common);

}  // namespace toile
