// What `toile try` took for granted of a drawing, and how to say otherwise.
#pragma once

#include <string>
#include <vector>

#include "tools/find_seams/run.h"
#include "tools/import_pattern/run.h"

namespace toile {

/// One thing that the drawing left to guess, or that a newcomer has to look at.
struct Taken {
  std::string what;    ///< unit, grain, halves, pairs, spare_pieces or undecided_seams
  std::string taken;   ///< what it was taken for
  std::string change;  ///< the option, the command or the stroke that changes it
};

/// One of each, in that order. `aside` are panels that no seam holds to the rest. `edit_seams` is
/// the command that shows the seams.
std::vector<Taken> taken_for_granted(const ImportEnd& imported, const FindSeamsEnd& seams,
                                     const std::vector<LeftOut>& aside,
                                     const std::string& edit_seams);

/// "spare pieces: pocket (pocket); to change: --with pocket".
std::string line_of(const Taken& taken);

}  // namespace toile
