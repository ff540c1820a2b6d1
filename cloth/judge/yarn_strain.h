// The strain of a dressed garment's yarns along warp and weft, and the angle between them.
#pragma once

#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// Of a triangle. Strains are fractions, negative where the yarns are slack.
struct YarnStrain {
  double weft = 0;
  double warp = 0;
  double shear = 0;  ///< radians off the right angle between the yarns

  double largest() const { return weft > warp ? weft : warp; }
};

/// One per triangle, with the material points at `points`. Warp runs along the panel's grain.
std::vector<YarnStrain> yarn_strains(const PanelMesh& garment, const std::vector<Vec3>& points);

/// Per triangle, whether it lies on a gathered seam. Yarns are drawn up there into folds finer than
/// the mesh, so their strain means nothing.
std::vector<char> on_gathers(const PanelMesh& garment);

}  // namespace toile
