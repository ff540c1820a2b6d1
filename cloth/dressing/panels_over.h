// Panels of a garment that lie over another, though the garment itself is below it.
#pragma once

#include <string>
#include <vector>

#include "geometry/distance_grid.h"
#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The indices of the panels whose names fit one of the patterns, `*` for any letters. Throws Error
/// for a pattern that fits none.
std::vector<int> panels_named(const PanelMesh& garment, const std::vector<std::string>& patterns);

/// Takes the triangles of these panels out of all of a garment's.
void leave_out(const PanelMesh& garment, const std::vector<int>& panels,
               std::vector<Triangle>& triangles);

/// Brings the given panels of a dressed garment from below another garment over it. `below` is the
/// surface that the garment lies on. `above` is the same surface with the other garment on it.
/// Each node of the panels moves out along the gradient of `below`, until it is as far from `above`
/// as it was from `below`. So what lay over another in these panels still does. Nodes stay where
/// the other garment is not.
/// Nodes of a seam to a panel that is not flipped over move too. So that seam has to be clear of
/// the other garment. `nodes` and `triangles` are the dressed garment's, in its order. Returns
/// which nodes moved.
std::vector<char> flip_over(const PanelMesh& garment, const std::vector<int>& panels,
                            const DistanceGrid& below, const DistanceGrid& above,
                            const std::vector<Triangle>& triangles, std::vector<Vec3>& nodes);

}  // namespace toile
