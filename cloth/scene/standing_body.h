// A body as it stood when its garment was put on, and its way from there into a pose.
#pragma once

#include "cloth/scene/collider.h"
#include "cloth/scene/scene.h"
#include "geometry/body/skeleton.h"
#include "geometry/surface_morph.h"

namespace toile {

/// The body of a scene, before it came into its pose.
struct StandingBody {
  Collider collider;
  Skeleton skeleton;
  SurfaceMorph motion;  ///< from this body to the scene's
};

/// The scene around the body as it stood, or the scene itself where it has none.
Scene standing_scene(const Scene& scene);

}  // namespace toile
