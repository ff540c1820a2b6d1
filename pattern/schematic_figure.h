// Panels that are to stand by body part, before any body is known.
#pragma once

#include "pattern/pattern.h"

namespace toile {

/// Turns and moves a panel that its placement positions to that side of a schematic figure, arms
/// hanging, so that what is found from placed panels (how a seam runs, which face is out) and what
/// is seen of them makes sense. A body's skeleton puts them right.
void stand_schematically(PatternPanel& panel);

}  // namespace toile
