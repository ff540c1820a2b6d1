#include "pattern/seams/seam_certainty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

namespace {

/// Fitted by fit_seam_certainty.py, with and without names: to 90 random garments that the trees
/// were not learned from, and to 29 drawings. Of those, each was judged with trees that were
/// learned without it and its like.
constexpr SeamFeatures feature_weights = {-1.846, 1.619,  1.676, 1.734,  0.016, -0.505,
                                          0.192,  -0.484, 0.731, -0.856, 3.987, -2.181};

constexpr std::array<const char*, seam_features> names = {
    "one",   "found",        "gap",      "garment_gap", "settled", "edges",
    "named", "equal_length", "gathered", "coincide",    "likely",  "cut"};

}  // namespace

const char* name_of(SeamFeature feature) { return names[static_cast<int>(feature)]; }

double certainty_of(const SeamFeatures& features) {
  double sum = 0;
  for (int i = 0; i < seam_features; ++i) sum += features[i] * feature_weights[i];
  const double certainty = 1 / (1 + std::exp(-sum));
  const bool gathered = features[static_cast<int>(SeamFeature::gathered)] > std::numbers::ln2;
  const bool is_likely = features[static_cast<int>(SeamFeature::likely)] > 0;
  return gathered && !is_likely ? std::min(certainty, 0.5) : certainty;
}

}  // namespace toile
