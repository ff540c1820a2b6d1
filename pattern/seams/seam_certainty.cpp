#include "pattern/seams/seam_certainty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

namespace {

/// Fitted by fit_seam_certainty.py, with and without names: to 120 random garments that the trees
/// were not learned from, and to drawings.
constexpr SeamFeatures feature_weights = {-0.801, 0.014,  1.871,  1.439,  -0.216, -0.275,
                                          0.777,  -0.245, -0.631, -1.098, 4.133};

}  // namespace

double certainty_of(const SeamFeatures& features) {
  double sum = 0;
  for (int i = 0; i < seam_features; ++i) sum += features[i] * feature_weights[i];
  const double certainty = 1 / (1 + std::exp(-sum));
  const bool gathered = features[static_cast<int>(SeamFeature::gathered)] > std::numbers::ln2;
  const bool is_likely = features[static_cast<int>(SeamFeature::likely)] > 0;
  return gathered && !is_likely ? std::min(certainty, 0.5) : certainty;
}

}  // namespace toile
