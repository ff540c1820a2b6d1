// Panels whose place another panel of the drawing has: long sleeves beside short ones.
#pragma once

#include <set>

#include "pattern/seams/find_seams.h"

namespace toile {

/// Panels of loose parts, which decided seams do not join to the largest one. They would have the
/// seams of other panels if those were not there, and fit no open edge better. A mirror image of
/// the others, or a panel of their shape, is not spare. A left and a right panel go together.
///
/// `found` are the pattern's seams. Costs a short search a panel, where a part is loose.
std::set<int> spare_panels(const Pattern& pattern, const FindSeamsOptions& options,
                           const FoundSeams& found);

}  // namespace toile
