#include "pattern/seams/seam_certainty.h"

#include <cmath>

namespace toile {

namespace {

/// fit_seam_certainty.py fitted them to what is found in the 96 random garments that seam_weights
/// were fitted to, with and without names.
constexpr SeamFeatures feature_weights = {-2.297, 2.804, 2.010, 1.500,  0.939,
                                          -0.962, 1.359, 0.203, -0.529, -0.496};

}  // namespace

double certainty_of(const SeamFeatures& features) {
  double sum = 0;
  for (int i = 0; i < seam_features; ++i) sum += features[i] * feature_weights[i];
  return 1 / (1 + std::exp(-sum));
}

}  // namespace toile
