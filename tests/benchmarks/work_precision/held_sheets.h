// Sheets that are held at nodes and touch nothing: the hanging cloth and the cantilever.
#pragma once

#include <memory>

#include "tests/benchmarks/work_precision/case.h"

namespace toile::precision {

/// The cloth of the paper's Fig. 9, of the default fabric: 1 m square, nodes_across², two corners
/// held, let go from the horizontal.
std::unique_ptr<Case> hanging_cloth(int nodes_across);

/// A strip of 10 × 5 cm, 0.2 kg/m², clamped level, of weight group 10 [reference case 4], with its
/// mirror image on the other side of the clamp.
std::unique_ptr<Case> cantilever(int elements);

}  // namespace toile::precision
