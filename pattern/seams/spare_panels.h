// Panels whose place another panel of the drawing has: long sleeves beside short ones.
#pragma once

#include <set>

#include "pattern/seams/find_seams.h"

namespace toile {

/// Panels without which the garment is sewn better. `found` are its seams.
///
/// A seam is wanted where two edges are likely partners and one of them is open. The garment is
/// sewn better where the open edges of wanted seams are shorter, and nothing of the rest loses its
/// seam. An open edge of a panel that is left out counts where its partner is open, too.
///
/// A loose part would have the seams of other panels if they were not there, and fits no open edge
/// better: it is spare, too. Nothing is spare where seams are wanted in the end. What has the shape
/// of a panel that stays, or is its mirror image, is not spare.
///
/// A left and a right panel go together. Costs a short search a panel; none where no seam is
/// wanted.
std::set<int> spare_panels(const Pattern& pattern, const FindSeamsOptions& options,
                           const FoundSeams& found);

}  // namespace toile
