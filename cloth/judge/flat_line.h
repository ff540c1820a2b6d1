// Straight lines across flat panels.
#pragma once

#include <array>

#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Flat corners of a triangle, metres.
std::array<Vec2, 3> flat_corners(const PanelMesh& garment, int triangle);

/// Metres of a line that run through a flat triangle of counter-clockwise corners. The line begins
/// at `from` and runs along the unit vector `direction`. A value that is not positive says that the
/// line misses the triangle. A line along an edge counts for the triangles on both sides.
double length_within(const std::array<Vec2, 3>& corners, const Vec2& from, const Vec2& direction);

}  // namespace toile
