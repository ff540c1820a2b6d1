// How far the drape of a symmetric pattern is from its mirror image.
#pragma once

#include <optional>
#include <string>

#include "pattern/panel_mesh.h"

namespace toile {

/// How mirrored points differ, in height or in their distance from the mid-plane. Lengths in
/// metres.
struct Asymmetry {
  double largest = 0;  ///< of all points; loose folds fall otherwise left and right
  double height = 0;   ///< mean over a panel: by which it is lower; folds cancel out
  double across = 0;   ///< mean over a panel: by which it is farther from the mid-plane
  std::string panel;   ///< of which the larger mean is the largest
  std::string mirror;  ///< the panel that is its mirror image, or itself

  double crooked() const { return height > across ? height : across; }
};

/// Measures the drape of a pattern that is symmetric in shape and seams. Mirrored points are those
/// that a panel's mirror image covers on its partner. The mid-plane is x = `middle` (metres).
///
/// A pattern is symmetric when each panel has a partner, itself or another one. Laid upon its
/// partner's outline, its mirrored outline is off by 3 mm at most. Of several ways to lay it, that
/// one counts which mirrors best where the panels start. Points that are sewn together have
/// mirrored points that lie together, within 1 cm. Fabrics have to be the same; grain, elastics and
/// names play no part.
///
/// None: the pattern is not symmetric, or a seam stands open. Where the body is not symmetric, its
/// own asymmetry is part of the figure. Each of the panels' points is mirrored, up to
/// `mirrored_points` a panel. Quadratic in the points of two outlines, for panels as long around.
std::optional<Asymmetry> measure_asymmetry(const PanelMesh& pattern, const DressedGarment& dressed,
                                           double middle);

}  // namespace toile
