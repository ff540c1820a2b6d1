// The path data of SVG, and its basic shapes as paths.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/types.h"
#include "io/drawn_path.h"

namespace toile {

/// The paths of a `d` attribute: all commands of SVG 1.1, absolute and relative. Arcs become cubics
/// that leave them by at most 5e-6 of their radius. Paths without a segment are left out. Throws
/// Error with `place` for what can't be read, and for more than max_svg_segments segments.
std::vector<DrawnPath> svg_path_data(std::string_view text, const std::string& place);

/// The value of a `points` attribute as one path. Throws Error with `place` for half a point.
std::vector<DrawnPath> svg_polygon(std::string_view text, bool closed, const std::string& place);

/// A rectangle with round corners of radii `radii`, from its corner (x, y).
DrawnPath svg_rectangle(const Vec2& corner, const Vec2& size, const Vec2& radii);
DrawnPath svg_ellipse(const Vec2& centre, const Vec2& radii);

/// Segments of one path at most.
inline constexpr std::size_t max_svg_segments = 1'000'000;

}  // namespace toile
