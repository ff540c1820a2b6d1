// The force that attracts cloth to the body while its seams close.
#pragma once

#include "cloth/scene/scene.h"
#include "geometry/types.h"

namespace toile {

/// The force (N) that attracts a vertex at `p` (metres) to the skin. It is `weight` (N) from
/// full_attraction_distance (5 cm) on. Nearer, it falls in proportion to the distance
/// [Zhong & Xu 2009, wrapping]. The scene has a body.
Vec3 body_attraction(const Scene& scene, const Vec3& p, double weight);

}  // namespace toile
