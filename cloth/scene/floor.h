// The floor on which a body stands.
#pragma once

#include <optional>

#include "cloth/scene/scene.h"
#include "geometry/distance_grid.h"
#include "geometry/types.h"

namespace toile {

/// Metres: the height of the floor below `body`. It is y = 0, or the body's lowest point where that
/// is lower. None: gravity does not pull down more than sideways, and the body lies rather than
/// stands. Linear in the body's points.
std::optional<double> floor_below(const TriangleMesh& body, const Vec3& gravity);

/// The signed distance to body, layers and floor, and its gradient. It is the nearest one's, so it
/// is the body's own wherever the floor is farther. Beneath a sole the floor gives way until cloth
/// has `offset` metres to both: who steps on a hem stands on it. The scene has a body. Costs a
/// lookup in the body's grid.
DistanceGrid::Sample obstacle_at(const Scene& scene, const Vec3& p, double offset);

}  // namespace toile
