// Finds which edges of a pattern are sewn together.
#pragma once

#include <string>
#include <vector>

#include "toile/error.h"
#include "toile/values.h"

namespace toile {
inline namespace library {

struct FindSeamsChoices {
  bool keep = false;                      ///< the stitches of the pattern stay
  std::vector<std::string> sewn = {};     ///< "front:3 back:1": panels and edges, counted from 0
  std::vector<std::string> with = {};     ///< panels to take in that are no pieces of the shell
  std::vector<std::string> without = {};  ///< panels to leave out
  double min_confidence = 0.7;            ///< 0 to 1: a less certain seam is not sewn
  double time_limit = 0;                  ///< seconds, then the best so far is taken; 0: none
};

/// The pattern with its seams. Its report lists them, sewn and `undecided`. Throws Error for names
/// that the pattern does not have. The same as find-seams; seconds for ten panels.
TOILE_API SewingPattern find_seams(const SewingPattern& pattern,
                                   const FindSeamsChoices& choices = {});

}  // namespace library
}  // namespace toile
