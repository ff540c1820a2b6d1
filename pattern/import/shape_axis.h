// Which way the warp runs in a piece without a grain line, as far as its outline tells it.
#pragma once

#include <optional>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// The direction along or across which a piece is cut.
struct ShapeAxis {
  double angle = 0;       ///< radians from +x, counter-clockwise
  bool mirrored = false;  ///< the piece is its own mirror image about one line, along or across
};

/// What a closed outline tells of that, if anything. It turns and is mirrored with the outline.
///
/// - A piece that is its own mirror image about one line, within 2 mm, is cut along or across that.
///   One that is about two, as a band, tells nothing.
/// - Otherwise the longest straight side tells it that has all of the piece beside it and a right
///   angle at an end. Folds and hems have: unfolded they run on smoothly. Side seams have none.
///
/// O(n^2) of its points.
std::optional<ShapeAxis> shape_axis(const std::vector<Vec2>& outline);

/// The direction in which the area of an outline is longest. Radians from +x, as above.
double longest_direction(const std::vector<Vec2>& outline);

}  // namespace toile
