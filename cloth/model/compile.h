// Compiles a scene against a garment: welds its seams and lays out the terms.
#pragma once

#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/scene/scene.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Welds the seams' points to nodes, and fills the arrays of the terms that the scene asks for. A
/// node starts at the mean of its points in `placed` (metres, one per material point). O(n log n)
/// in the triangles. Throws Error when a triangle has no area or is sewn to itself, and as
/// attached_points() and fabric_of() do.
GarmentModel compile(const PanelMesh& garment, const Scene& scene, const std::vector<Vec3>& placed);
/// The same, but `body_offset` metres are kept from the skin instead of body_offset_of().
GarmentModel compile(const PanelMesh& garment, const Scene& scene, const std::vector<Vec3>& placed,
                     double body_offset);

}  // namespace toile
