// How often a found seam is right, told from how the searches found it.
#pragma once

#include <array>

namespace toile {

/// What tells right seams from wrong ones. Shares are 0 to 1.
enum class SeamFeature {
  one,           ///< 1
  found,         ///< share of the searches that sew it
  gap,           ///< log(1 + by how much the best garment without it scores less, at most 6)
  garment_gap,   ///< `gap` of all of these; the mean
  settled,       ///< share of the searches that ended with the garment's score
  edges,         ///< logarithm of the number of edges
  named,         ///< 1: the name of a piece says its kind, face or side, of any of the garment
  equal_length,  ///< 1, falling by e for each 0.5 % by which the lengths differ
  gathered,      ///< logarithm of the longer over the shorter side
  coincide,      ///< 1: the edges coincide
  likely,        ///< logarithm of the odds of the pair alone, see sewn_logit(); within ±10, tenths
  cut,           ///< 1: an edge was cut for it, so that its sides are as long as each other
  count
};

inline constexpr int seam_features = static_cast<int>(SeamFeature::count);

using SeamFeatures = std::array<double, seam_features>;

const char* name_of(SeamFeature feature);

/// The share of such seams that is right, 0 to 1: a logistic regression (Cox 1958). At most 0.5
/// where one side is twice as long as the other and the pair alone is unlikely.
double certainty_of(const SeamFeatures& features);

}  // namespace toile
