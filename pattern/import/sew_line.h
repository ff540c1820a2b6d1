// Sew lines that a drawing does not name.
#pragma once

#include <vector>

#include "pattern/import/piece.h"

namespace toile {

/// Whether the closed path runs within the boundary, along all of it, as a sew line does: no point
/// of the boundary is farther than 60 mm from it. On an edge without allowance both may be one.
/// A dart or a pocket does not. Compares at most 400 points of each with all of the other.
bool runs_along(const std::vector<Vec2>& boundary, const PiecePath& path);

}  // namespace toile
