// Polygons made smaller all around.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// What is left of a simple polygon when a border of `distance` metres is taken off. That is one
/// polygon, none, or several where it falls apart. All run counter-clockwise, as `outline` does.
/// Sides stay parallel and corners sharp, as by a straight skeleton. Points within 0.01 mm of the
/// line between others are left out first. Time and memory are about O(n^2) of the others.
std::vector<std::vector<Vec2>> inset_polygon(const std::vector<Vec2>& outline, double distance);

}  // namespace toile
