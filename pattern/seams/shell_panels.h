// Which panels are pieces of a garment's shell, the cloth that is seen and dressed.
#pragma once

#include <string>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// A panel that is no piece of the shell.
struct BesideShell {
  int panel = 0;
  std::string kind;  ///< see kind_beside_shell()
};

/// Pockets, linings and the like, by names and materials. Empty where no panel would be left.
std::vector<BesideShell> panels_beside_shell(const Pattern& pattern);

/// The text of a pattern file without these panels and the stitches that hold them. All else stays
/// as it is; without panels to leave out, the text itself.
std::string without_panels(const std::string& text, const std::vector<std::string>& names);

}  // namespace toile
