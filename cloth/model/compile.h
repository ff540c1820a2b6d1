// Compiles a scene against a garment: welds its seams and lays out the terms.
#pragma once

#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/scene/scene.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Welds the seams' points to nodes, and lays out the terms that the scene asks for. Nodes start
/// in the middle of the places their points have in `placed`.
/// Throws Error when a triangle would lose its area by being sewn to itself.
GarmentModel compile(const PanelMesh& garment, const Scene& scene, const std::vector<Vec3>& placed);
/// The same with `body_offset` metres kept from the skin, instead of body_offset_of().
GarmentModel compile(const PanelMesh& garment, const Scene& scene, const std::vector<Vec3>& placed,
                     double body_offset);

}  // namespace toile
