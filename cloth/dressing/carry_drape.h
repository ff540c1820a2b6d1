// Carries the drape of a garment over to the garment after its pattern was changed a little.
#pragma once

#include <string>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// Where an earlier drape puts a garment's points.
struct CarriedDrape {
  std::vector<Vec3> points;  ///< metres, per material point; empty: `refusal` says why
  double outside = 0;        ///< metres: the farthest that a point lies outside the earlier panel
  double shifted = 0;        ///< metres: the farthest that a seam's point is from where it was
  std::string refusal;       ///< why the garment is another one; empty: it is not
};

/// Finds panels by their names and points by their flat coordinates. A point of an earlier triangle
/// lies in that triangle of the drape. Where a seam was moved, its points lie on the earlier
/// outline, and the panel between its seams is stretched or squeezed evenly. A point outside the
/// earlier panel, as of a longer hem, continues the plane of the nearest triangle. Refused are
/// garments with other panels, with points more than max_carried_outside from the earlier panel,
/// and with seams whose sides are more than max_carried_gap apart. O(n^1.5).
CarriedDrape carry_drape(const DressedGarment& earlier, const PanelMesh& garment);

}  // namespace toile
