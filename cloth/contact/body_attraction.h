// What draws cloth to the body while it is wrapped.
#pragma once

#include "cloth/scene/scene.h"
#include "geometry/types.h"

namespace toile {

/// The force that draws a vertex of weight `weight` (N) at `p` toward the skin: that weight from
/// 5 cm on, less nearer by [Zhong & Xu 2009, wrapping: adaptive to the distance]. The scene has a
/// body.
Vec3 pull_to_body(const Scene& scene, const Vec3& p, double weight);

}  // namespace toile
