// The transforms of SVG: of elements, and of a view box into its frame.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>

#include "geometry/types.h"
#include "io/drawn_path.h"

namespace toile {

/// An affine map of the plane.
using PlaneTransform = Eigen::Transform<double, 2, Eigen::AffineCompact>;

/// The value of a `transform` attribute: matrix, translate, scale, rotate, skewX and skewY, in any
/// number. Throws Error with `place` for anything else.
PlaneTransform svg_transform(std::string_view text, const std::string& place);

/// What maps the view box `corner`, `size` to the frame from (0, 0) to `frame`, as the value of
/// `preserveAspectRatio` says; empty is its default. Throws Error with `place` for other values.
PlaneTransform svg_view_transform(const Vec2& corner, const Vec2& size, const Vec2& frame,
                                  std::string_view aspect, const std::string& place);

/// The path as the transform maps it.
DrawnPath transformed(const DrawnPath& path, const PlaneTransform& transform);

}  // namespace toile
