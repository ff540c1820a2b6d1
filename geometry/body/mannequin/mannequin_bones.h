// The bones of the standing mannequin and the points by which it is posed.
#pragma once

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// Joints and points of a mannequin at rest, metres, with the soles on y = 0. Points of feet and
/// hands are of the left side.
struct MannequinBones {
  Skeleton joints;
  Vec3 ball_of_foot = Vec3::Zero();  ///< on the line across the ball, on the sole
  Vec3 toe_tip = Vec3::Zero();
  Vec3 heel = Vec3::Zero();
  Vec3 finger_tip = Vec3::Zero();
  double knee_reach = 0;  ///< from the joint to where the limb begins to bend, about its thickness
  double elbow_reach = 0;
  double toes_reach = 0;
  Vec3 low = Vec3::Zero();  ///< corners of a box that holds the mannequin at rest
  Vec3 high = Vec3::Zero();
  Vec3 trunk_low = Vec3::Zero();  ///< corners of a box that holds trunk and head
  Vec3 trunk_high = Vec3::Zero();
};

/// Those of the sample mannequin.
const MannequinBones& sample_bones();

}  // namespace toile
