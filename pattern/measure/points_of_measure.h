// The points of measure that a technical designer takes on a garment that lies flat.
#pragma once

#include <string>
#include <vector>

#include "pattern/measure/sewn_panels.h"

namespace toile {

struct PointOfMeasure {
  std::string name;  ///< "half chest", "left sleeve length"
  std::string rule;  ///< how it is taken, for measure_by_rule()
};

/// The points of measure that seams, classes and shapes of the panels tell.
///
/// - Of what hangs from the shoulders: half chest 2.5 cm below the armhole, across shoulder,
///   shoulder, armhole, neckline, neck width and drops, half hem. Lengths of front and back are
///   taken from the neck's side and in the centre. Without shoulders: half top edge.
/// - Of sleeves: length from the shoulder, half biceps 2.5 cm below the armhole, half opening,
///   inseam.
/// - Of skirts and trousers: half waist, length, half hem; of each leg rises, inseam, outseam, half
///   thigh 2.5 cm below the crotch, half leg opening.
///
/// Names with a side stand for one of two. What the seams don't tell is left out. Cost:
/// quadratic in the edges at most.
std::vector<PointOfMeasure> points_of_measure(const SewnPanels& panels);

}  // namespace toile
