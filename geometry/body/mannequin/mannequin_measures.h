// The measures of a finished mannequin.
#pragma once

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/body/measure_values.h"

namespace toile {

/// What a tape reads on the mesh of a standing mannequin, both sides as one. It is what
/// measure_body() finds. Where that finds nothing, it is read at the mannequin's own places: girths
/// of trunk and limbs, heights, and lengths between joints. Costs measure_body() and 150 slices.
MeasureValues mannequin_measures(const Mannequin& mannequin);

/// What a standing body lacks of these measures, by proportion: those of the sample mannequin that
/// are not `known`. Girths, arcs, spans and widths are scaled by the mean of bust, waist and hip
/// against the sample's, lengths and heights by the height. Where none of these is known, they
/// stay. Both sides are one. Costs a mannequin.
MeasureValues measures_by_proportion(const MeasureValues& known);

/// The name of a girth as a measure: "upper thigh" is upper_thigh.
std::string measure_of(const MannequinGirth& girth);

}  // namespace toile
