// Girths of a body's limbs before and after it was posed.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

struct LimbGirth {
  std::string name;     ///< such as "left thigh 60 %" (from hip to knee) or "left knee"
  double standing = 0;  ///< metres
  double posed = 0;     ///< metres
};

/// Girths of arms and legs in planes square to the bones, as a tape measures them, at these shares:
/// - upper arm: 50 and 70 %;
/// - forearm: 30, 60 and 90 %;
/// - thigh: 40, 60 and 80 %;
/// - shin: 20, 40, 60 and 80 %.
///
/// At elbow and knee the plane halves the angle of the bones.
///
/// Both bodies are closed, with all of joint_names, in metres. Throws Error where a plane misses
/// its body. It costs 56 slices.
std::vector<LimbGirth> limb_girths(const TriangleMesh& standing, const Skeleton& standing_joints,
                                   const TriangleMesh& posed, const Skeleton& posed_joints);

}  // namespace toile
