// Straight lines across flat panels.
#pragma once

#include <array>

#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Flat corners of a triangle, metres.
std::array<Vec2, 3> flat_corners(const PanelMesh& garment, int triangle);

/// Metres of the line that begins at `from` and goes along the unit vector `way` which run through
/// a flat triangle of counter-clockwise corners; not positive: it misses the triangle. A line along
/// an edge counts for the triangles on both sides.
double length_within(const std::array<Vec2, 3>& corners, const Vec2& from, const Vec2& way);

}  // namespace toile
