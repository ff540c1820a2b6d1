// A body as it stood when its garment was put on, and its way from there into a pose.
#pragma once

#include "cloth/scene/collider.h"
#include "geometry/body/skeleton.h"
#include "geometry/surface_morph.h"

namespace toile {

/// The body of a scene, before it came into its pose.
struct StandingBody {
  Collider collider;
  Skeleton skeleton;
  SurfaceMorph motion;  ///< from this body to the scene's
};

}  // namespace toile
