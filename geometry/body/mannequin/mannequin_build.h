// The build of a mannequin: by which factors it differs from the sample.
#pragma once

#include <array>

#include "geometry/body/mannequin/mannequin_shape.h"

namespace toile {

/// What a build can change, each apart from the others. A height is that of the level above the
/// floor. A girth scales the sections there, between them the factors go over smoothly.
enum class BuildPart {
  height,
  cervicale_height,
  bust_height,
  waist_height,
  hip_height,
  crotch_height,
  knee_height,
  arm_length,
  head,
  neck,
  shoulder_width,
  chest,  ///< the trunk at the bust, without breasts
  breast,
  bust_span,
  underbust,
  waist,
  abdomen,
  hip,
  upper_thigh,
  mid_thigh,
  knee,
  calf,
  ankle,
  upper_arm,
  elbow,
  wrist,
};
inline constexpr int build_parts = 26;

/// Factors to the sample mannequin, positive. All 1 is the sample.
class MannequinBuild {
 public:
  MannequinBuild() { factors_.fill(1); }
  double operator[](BuildPart part) const { return factors_[static_cast<std::size_t>(part)]; }
  double& operator[](BuildPart part) { return factors_[static_cast<std::size_t>(part)]; }

 private:
  std::array<double, build_parts> factors_;
};

/// The height in metres of the sample mannequin at which a level of a build is counted. 0 for a
/// part that is no height.
double sample_height(BuildPart part);

/// Whether the levels of the body rise from the floor to the crown.
bool levels_rise(const MannequinBuild& build);

/// The sample mannequin in another build: the rows of its lofts are moved and scaled, its
/// ellipsoids and joints go with them. Arms stay out at 45 degrees, the thighs keep their relative
/// gap. Throws Error where levels_rise() does not hold.
MannequinShape built_mannequin(const MannequinBuild& build);

}  // namespace toile
