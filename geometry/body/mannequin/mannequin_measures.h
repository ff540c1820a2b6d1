// The measures of a finished mannequin.
#pragma once

#include "geometry/body/body_measures.h"
#include "geometry/body/mannequin/mannequin.h"

namespace toile {

/// What a tape reads on the mesh of a standing mannequin: height, bust, waist and hip where the
/// surface has them, with their heights; crotch height; girths of the limbs, neck, head, underbust
/// and abdomen. Cervicale, knee, and arm length are those of the joints. It costs some 150 slices.
BodyMeasures mannequin_measures(const Mannequin& mannequin);

/// The name of a girth as a measure: "upper thigh" is upper_thigh.
std::string measure_of(const MannequinGirth& girth);

}  // namespace toile
