// What mesh-pattern would say of a pattern while its seams are drawn.
#pragma once

#include <string>

namespace toile {

/// JSON of `warnings` and `reversed`. `pattern` is JSON, too. Throws Error when it is no pattern.
///
/// - `warnings`: a list of `text`, `seams` and `panels`. Seams are the numbers of the stitches in
///   the pattern's text whose both sides the warning names, or else one side. Panels are the names
///   that it has. What mesh-pattern would refuse is in the list, too.
/// - `reversed`: per stitch whether the start of one edge meets the end of the other, as stated or
///   as orient() finds it. Null: the stitch holds a panel that is left out.
///
/// It does not mesh, so that it takes milliseconds. Warnings that need the mesh, such as those of
/// cut-outs, are not in it.
std::string pattern_check_json(const std::string& pattern);

}  // namespace toile
