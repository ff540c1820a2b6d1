// How often a found seam is right, told from how the searches found it.
#pragma once

#include <array>

namespace toile {

/// What tells right seams from wrong ones. Shares are 0 to 1.
enum class SeamSign {
  one,             ///< 1
  shaken,          ///< share of the searches with shaken weights that sew it
  plain,           ///< share of the searches with the weights as they are that sew it
  gap,             ///< worth that the best garment without this seam lacks, at most 6; its logarithm
  neighbours,      ///< `shaken` of the seams beside it on the outlines; the mean
  neighbour_gap,   ///< `gap` of these; the mean
  garment_shaken,  ///< `shaken` of all seams of the garment; the mean
  garment_gap,     ///< `gap` of all of these; the mean
  settled,         ///< share of the searches that ended with the garment's worth
  edges,           ///< logarithm of the number of edges
  named,           ///< 1: names say what both pieces are
  coincide,        ///< 1: the two edges coincide
  equal,           ///< 1: other edges, equally long to 0.1 mm
  unequal,         ///< logarithm of the longer over the shorter
  lopsided,        ///< 1: its mirror image is not sewn
  count
};

inline constexpr int seam_signs = static_cast<int>(SeamSign::count);

using SeamSigns = std::array<double, seam_signs>;

/// The share of such seams that is right, 0 to 1: a logistic regression (Cox 1958).
double certainty_of(const SeamSigns& signs);

}  // namespace toile
