// A mannequin by measures.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/mannequin/mannequin_build.h"
#include "geometry/body/measure_values.h"

namespace toile {

/// A measure that was asked for and what the mannequin has.
struct FittedMeasure {
  std::string name;
  double wanted = 0;       ///< metres
  double measured = 0;     ///< metres; NaN: nothing reads this measure on a mannequin
  bool is_given = false;   ///< else filled in
  bool is_fitted = false;  ///< some part of the build moves it
};

struct FittedMannequin {
  Mannequin mannequin;
  MannequinBuild build;
  std::vector<FittedMeasure> measures;  ///< in the order of their names
  Pose pose;  ///< in which it was measured: standing, the arms as high as frees the bust
};

/// Finds the build whose mesh, standing, has the measures `given`, and those of `filled` about. It
/// returns that body in the pose of the options. Each round makes a mesh and measures it. Lengths
/// between levels of the trunk and legs that stay off by more than 2 cm are left out then.
///
/// The unknowns are the logarithms of the build's factors, by least squares. Filled measures set
/// their start. Each factor is pulled to its start with a weight of 1 to 3 %. In the first Jacobian
/// each part moves its own measure alone. What the rounds show corrects it [Schubert 1970]. Where
/// the section at the bust holds the arms, they are raised by steps of 15 degrees, to 80 at most. A
/// body asked for in the standing pose has them so, unless it `keeps_pose`. It ends when each given
/// measure that can be read is within 1 mm, or after 14 rounds with the best one. Measures that
/// contradict each other end it sooner. Throws Error where levels of the body would not rise, and
/// as mesh_mannequin() does.
FittedMannequin fit_mannequin(const MeasureValues& given, const MeasureValues& filled,
                              FigureType figure, const MannequinOptions& options,
                              bool keeps_pose = false);

}  // namespace toile
