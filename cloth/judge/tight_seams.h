// Seams that a hand could not close: where the cloth is too tight, and by how much.
#pragma once

#include <string>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/model/stretch.h"

namespace toile {

struct TightSeam {
  std::string name;
  double tension = 0;  ///< N/m across the seam: the largest mean over a hand's breadth
  double missing = 0;  ///< metres of cloth beside the seam, where the most is missing
};

/// The seams of a garment at rest that a hand could not have closed. Two things make a seam tight.
/// - Over `hand_breadth`, or all of a shorter seam, the mean tension across it exceeds `hand_pull`.
///   For a soft fabric the bound is the tension that strains the cloth by `max_worn_strain`.
/// - More cloth is missing beside the seam than `flesh_give`.
///
/// Tension and stretch are those of the cloth's inner face (InnerFace), where the scene has a body.
///
/// Missing is the stretch of the cloth along the line square to the seam, through the panels on
/// both sides. Half of a panel's stretch counts for the seam at its other end. So all seams around
/// a tube together lack what the tube lacks.
///
/// `nodes` are the model's. `multipliers` are one a triangle; empty: none acts. Linear in the
/// seams, and for the seams that are tight in the triangles too.
std::vector<TightSeam> tight_seams(const PanelMesh& garment, const GarmentModel& model,
                                   const std::vector<Vec3>& nodes,
                                   const std::vector<LimitMultiplier>& multipliers = {});

}  // namespace toile
