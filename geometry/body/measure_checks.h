// Whether measures can be those of one body.
#pragma once

#include <vector>

#include "geometry/body/measure_values.h"

namespace toile {

/// What no body can have, one sentence a contradiction, with the measures that disagree and their
/// values in cm. Only measures that are there are looked at. The bounds are wide: they hold for the
/// smallest child of 0.6 m and the largest adults. Levels that were told from these measures are in
/// `derived`: one that no body has shows a wrong unit, but it contradicts no sum.
std::vector<std::string> contradictions(const MeasureValues& measures,
                                        const MeasureValues& derived = {});

}  // namespace toile
