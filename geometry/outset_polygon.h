// Polygons made larger all around.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// The outline of the simple polygon with a border of `distance` metres around it,
/// counter-clockwise. Sides stay parallel. Corners stay sharp; one that would reach farther than
/// three times the distance is cut off. Inlets narrower than the border close. Empty where no
/// border can be drawn.
std::vector<Vec2> outset_polygon(const std::vector<Vec2>& outline, double distance);

}  // namespace toile
