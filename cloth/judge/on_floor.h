// Cloth that lies on the floor.
#pragma once

#include <string>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile {

/// The names of the panels of which a point lies no higher than `height` (metres), in the garment's
/// order. What the floor bears presses itself below the distance that it keeps from the floor, so
/// `height` is that distance above it. Linear in the points.
std::vector<std::string> panels_on_floor(const PanelMesh& garment, const DressedGarment& dressed,
                                         double height);

}  // namespace toile
