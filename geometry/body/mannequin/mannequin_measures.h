// The measures of a finished mannequin.
#pragma once

#include "geometry/body/body_measures.h"
#include "geometry/body/mannequin/mannequin.h"

namespace toile {

/// What a tape reads on the mesh of a standing mannequin, both sides as one. It is what
/// measure_body() finds. Where that finds nothing, it is read at the mannequin's own places: girths
/// of trunk and limbs, heights, and lengths between joints. Costs measure_body() and 150 slices.
BodyMeasures mannequin_measures(const Mannequin& mannequin);

/// The name of a girth as a measure: "upper thigh" is upper_thigh.
std::string measure_of(const MannequinGirth& girth);

}  // namespace toile
