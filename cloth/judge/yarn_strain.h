// What the yarns of a dressed garment feel: strain along warp and weft, and the angle between them.
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

/// One per triangle, its material points at `points`. Warp runs along the panel's grain.
std::vector<YarnStrain> yarn_strains(const PanelMesh& garment, const std::vector<Vec3>& points);

/// Per triangle, whether it lies on a gathered seam, where yarns are drawn up into folds finer than
/// the mesh: their strain says nothing there.
std::vector<char> on_gathers(const PanelMesh& garment);

}  // namespace toile
