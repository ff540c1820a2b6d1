#include "pattern/seams/seam_certainty.h"

#include <cmath>

namespace toile {

namespace {

/// fit_seam_certainty.py fitted them to what is found in the 96 random garments that seam_weights
/// were fitted to, with and without names.
constexpr SeamFeatures feature_weights = {-1.884, 2.460, 2.090, 1.468,  0.923,
                                          -0.998, 1.357, 0.305, -0.661, -0.628};

}  // namespace

double certainty_of(const SeamFeatures& features) {
  double sum = 0;
  for (int i = 0; i < seam_features; ++i) sum += features[i] * feature_weights[i];
  return 1 / (1 + std::exp(-sum));
}

}  // namespace toile
