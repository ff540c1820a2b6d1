// Polygons made smaller all around.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// What is left of the simple, counter-clockwise polygon when a border of `distance` metres is
/// taken off: one polygon, none, or several where it falls apart, counter-clockwise each. Sides
/// stay parallel and corners sharp, as by a straight skeleton. About O(n^2).
std::vector<std::vector<Vec2>> inset_polygon(const std::vector<Vec2>& outline, double distance);

}  // namespace toile
