// Few smooth curves in place of many short lines.
#pragma once

#include <array>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A cubic Bezier curve by its control points, or a line.
struct FittedCurve {
  std::array<Vec2, 4> points;
  bool straight = false;
};

/// Curves through the first and the last of `points`, each starting where the last one ends. No
/// point of them is farther than `tolerance` metres from the polyline, and no point of the
/// polyline is farther from them. One line or one curve comes out where that is enough. Otherwise
/// the curves meet without a corner, but where the polyline has one that the tolerance shows.
///
/// `points` are two or more, no two neighbours alike. About O(n log n).
std::vector<FittedCurve> fit_curves(const std::vector<Vec2>& points, double tolerance);

}  // namespace toile
