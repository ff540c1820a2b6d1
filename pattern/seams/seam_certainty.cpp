#include "pattern/seams/seam_certainty.h"

#include <cmath>

namespace toile {

namespace {

/// fit_seam_certainty.py fitted them to what is found in the 96 random garments that seam_weights
/// were fitted to, with and without names.
constexpr SeamFeatures feature_weights = {-3.020, 0.258, 2.893, 1.764, -0.511, 1.877,  1.129,
                                          -0.835, 1.057, 0.331, 0.265, -0.509, -0.482, 0.032};

}  // namespace

double certainty_of(const SeamFeatures& features) {
  double sum = 0;
  for (int i = 0; i < seam_features; ++i) sum += features[i] * feature_weights[i];
  return 1 / (1 + std::exp(-sum));
}

}  // namespace toile
