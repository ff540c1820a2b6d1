// Which panels are pieces of a garment's shell, the cloth that is seen and dressed.
#pragma once

#include <map>
#include <string>

#include "pattern/pattern.h"

namespace toile {

/// Panels that are no pieces of the shell, and what they are. They are those that the pattern
/// leaves out, and others by their names and materials, see kind_beside_shell(). Where no panel
/// would be left, they are the former alone.
std::map<int, std::string> panels_beside_shell(const Pattern& pattern);

/// The text of a pattern file that leaves out these panels, by name, and no others. The values say
/// why. All else stays as it is; where nothing changes, the text itself.
std::string with_left_out(const std::string& text, const std::string& name,
                          const std::map<std::string, std::string>& kinds);

}  // namespace toile
