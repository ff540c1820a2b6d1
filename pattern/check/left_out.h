// Panels that a pattern has, but that its garment is sewn without: pockets, linings and the like.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// The pattern without the panels that are left out, and without the stitches that hold them.
/// `remarks` gets a note that names them, and a warning where stitches are lost.
///
/// Throws Error when no panel is left.
Pattern without_left_out(Pattern pattern, std::vector<Remark>& remarks);

}  // namespace toile
