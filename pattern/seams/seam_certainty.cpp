#include "pattern/seams/seam_certainty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

namespace {

/// Fitted by fit_seam_certainty.py, with and without names: to 90 random garments that the trees
/// were not learned from, and to drawings.
constexpr SeamFeatures feature_weights = {-1.997, 2.800,  1.780,  -0.154, 0.386, 0.054,
                                          0.487,  -0.286, -0.915, -1.191, 3.381, 0};

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
