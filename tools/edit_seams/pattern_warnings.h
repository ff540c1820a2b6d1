// What mesh-pattern would warn of, at the seams that it names.
#pragma once

#include <string>

namespace toile {

/// JSON: a list of `text`, `seams` and `panels`. Seams are the numbers of the stitches in the
/// pattern's text whose both sides the warning names, or else one side. Panels are the names that
/// it has. What mesh-pattern would refuse is in the list, too. `pattern` is the pattern's JSON.
/// Throws Error when it is none.
///
/// It does not mesh, so that it takes milliseconds. Warnings that need the mesh, such as those of
/// cut-outs, are not in it.
std::string pattern_warnings_json(const std::string& pattern);

}  // namespace toile
