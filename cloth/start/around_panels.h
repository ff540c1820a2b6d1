// How panels go around their parts: which way up, and where around.
#pragma once

#include <functional>
#include <optional>

#include "pattern/panel_mesh.h"

namespace toile {

/// The direction of the flat panel that points up its part. It runs along the seam that closes the
/// panel, else across those to other panels. It points to the seams to other panels where
/// `to_partners` says so, else to the drawing's plus side. Linear.
PlacementAxis up_axis(const PanelMesh& garment, int panel, bool to_partners);

/// Whether a panel may be a strip: a collar, a waistband, a skirt of one panel. It is sewn to
/// others along its length only. A side that is sewn to others across it makes it a part of a
/// ring, as the halves of a waistband are. So do sewn sides that turn a corner, as the waist and
/// the sides of half a circle skirt. Linear in the points, and in the square of the panel's seams.
bool may_be_strip(const PanelMesh& garment, int panel);

/// How a panel that is rolled into a tube meets what it is sewn to.
struct TubeFit {
  /// 1: each of its points is sewn to a point at the same angle around the part. 0.64: it is sewn
  /// to one half of the way around, 0: to points at any angle.
  double share = 0;
  double turn = 0;  ///< radians from the panel's middle to where it fits best, from front to left
  PlacementAxis axis = PlacementAxis::plus_y;  ///< up, so that the right side lies outside
};

/// How a strip fits as a tube. Of a point that it is sewn to, `angle_of` tells the angle around the
/// part: radians, 0 in front, growing to the wearer's left. None: not known. Linear.
TubeFit tube_fit(const PanelMesh& garment, int panel,
                 const std::function<std::optional<double>(int)>& angle_of);

}  // namespace toile
