// The body's girth where cloth was drafted to lie.
#pragma once

#include <vector>

#include "cloth/ease/garment_levels.h"
#include "cloth/ease/girth_ease.h"
#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// Sets `drafted_body` of the levels whose cloth was drafted to lie on the trunk. Cloth is drafted
/// to lie where its panels start, as `pattern.placed` has them. `skeleton` has to have the joints
/// pelvis and chest. Costs one pass over the body a level.
void set_drafted_girths(const PanelMesh& pattern, const DressedGarment& dressed,
                        const TriangleMesh& body, const Skeleton& skeleton,
                        std::vector<GirthEase>& girths, std::vector<GarmentLevel>& levels);

}  // namespace toile
