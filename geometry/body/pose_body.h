// Brings a standing body into a pose: any body with a skeleton.
#pragma once

#include <string>

#include "geometry/body/open_crossings.h"
#include "geometry/body/pose.h"
#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

struct PosedBody {
  TriangleMesh surface;  ///< metres, with the triangles of the standing body, lowest point at y = 0
  Skeleton skeleton;
  OpenedCrossings crossings;
};

/// Poses a body that stands with arms and legs apart. side_motion() says what the angles mean.
///
/// The skin moves with the bones by skin_weights() and dual quaternions [Kavan et al. 2008]. At the
/// shoulder half of that is replaced by the linear blend, which bulges inward where dual
/// quaternions bulge outward. Creases that cross themselves are opened by open_crossings(); limbs
/// that go through each other stay so, and crossings.pairs_left counts them. The trunk stays
/// upright.
///
/// Sections within the core of a limb keep their girth to rounding.
///
/// It throws Error, with the place `name`, for a skeleton without all joints, and as skin_cores()
/// does. The pose has passed check_pose(). The same input gives the same bits, on any number of
/// threads.
PosedBody pose_body(const TriangleMesh& body, const Skeleton& skeleton, const Pose& pose,
                    const std::string& name);

}  // namespace toile
