// Gradient-boosted trees that tell how likely a pair of edges is sewn.
#pragma once

#include "pattern/seams/pair_features.h"

namespace toile {

/// Logarithm of the odds that a pair is sewn. Adds up one leaf of each tree.
double sewn_logit(const PairRow& row);

}  // namespace toile
