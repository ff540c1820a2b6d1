// Whether a line is the sew line of a boundary.
#pragma once

#include <optional>
#include <vector>

#include "pattern/import/piece.h"

namespace toile {

/// Whether the closed path runs within the boundary, along all of it, as a sew line does. No point
/// of the boundary may be farther than 60 mm from it. On an edge without allowance both may be one.
/// A dart or a pocket does not. Compares at most 400 points of each with all of the other.
bool runs_along(const std::vector<Vec2>& boundary, const PiecePath& path);

/// Whether a closed path that the drawing names a sew line can be the one of the boundary. It lies
/// within and bounds a tenth of the area or more. At most 5 % of the area lies more than 60 mm
/// beyond it. Programs write others where an allowance fails. Takes some thousand points of
/// the area, and compares each with at most 400 of both lines.
bool can_be_sew_line(const std::vector<Vec2>& boundary, const PiecePath& path);

/// One closed path of open sew lines that end on the boundary, within 1 mm. A piece has no
/// allowance along a part of its boundary: there the path goes on along it, from line to line.
/// Nothing where an end lies elsewhere. O(n) of the boundary's points, for each line.
std::optional<PiecePath> closed_along(const std::vector<Vec2>& boundary,
                                      const std::vector<PiecePath>& lines);

}  // namespace toile
