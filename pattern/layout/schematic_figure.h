// Places panels beside a schematic figure while no body is known.
#pragma once

#include "pattern/pattern.h"

namespace toile {

/// Sets rotation and translation of a panel that names its body part and side. It stands at that
/// side of a schematic figure 1.7 m tall, with arms hanging. So the placed panel tells how its
/// seams run and which face is out, and pictures of it make sense. When the garment is dressed, the
/// body's skeleton positions the panel.
void stand_schematically(PatternPanel& panel);

}  // namespace toile
