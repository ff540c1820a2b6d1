// Which seams would not close in a hand: where the cloth is too tight, and by how much.
#pragma once

#include <string>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/model/stretch.h"

namespace toile {

/// N per metre of seam that a hand pulls a seam together with, as in the paper's method.
inline constexpr double hand_pull = 300;
/// Metres of cloth that may be missing at a seam: as much as the flesh gives way.
inline constexpr double worn_tight = 0.01;

/// Strain that no seam is sewn to be worn at, however soft the fabric.
inline constexpr double max_worn = 0.25;

struct TightSeam {
  std::string name;
  double tension = 0;     ///< N/m across the seam, as a mean over a hand's breadth, the largest
  double missing_cm = 0;  ///< of cloth beside the seam, at the place that lacks the most
};

/// The seams of a garment at rest that a hand could not have closed: the tension across them
/// exceeds `hand_pull`, or what strains the cloth by `max_worn`, over 10 cm or all of the seam,
/// and more than `worn_tight` is missing. Missing is what the cloth is stretched by along the line
/// square to the seam through the panels on both sides; half of a panel's counts for the seam at
/// its other end, so that all seams around a tube together lack what the tube lacks. `nodes` are
/// the model's, `held` what holds each triangle to the scene's limits (empty: nothing). Linear in
/// the seams; in the triangles too for those that are tight.
std::vector<TightSeam> tight_seams(const PanelMesh& garment, const GarmentModel& model,
                                   const std::vector<Vec3>& nodes,
                                   const std::vector<LimitMultiplier>& held = {});

}  // namespace toile
