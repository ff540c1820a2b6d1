#include "pattern/seams/seam_certainty.h"

#include <cmath>

namespace toile {

namespace {

/// fit_seam_certainty.py fitted them to what is found in the 96 random garments that seam_weights
/// were fitted to, in 48 of these without names too. It overstates: see docs/programs.md.
constexpr SeamFeatures feature_weights = {-1.383, -0.196, 3.698,  1.658, -1.915, 0.303,  0.945,
                                          -0.173, 0.185,  -0.618, 0.026, -0.786, -0.089, -0.670};

}  // namespace

double certainty_of(const SeamFeatures& features) {
  double sum = 0;
  for (int i = 0; i < seam_features; ++i) sum += features[i] * feature_weights[i];
  return 1 / (1 + std::exp(-sum));
}

}  // namespace toile
