// Where a curve through noisy samples is greatest.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// The extreme of a curve through noisy samples, by a parabola through those near it.
struct Extreme {
  double at = 0;         ///< the argument
  double value = 0;      ///< there
  double curvature = 0;  ///< second derivative
  bool is_end = false;   ///< it lies at an end of the samples
};

/// The greatest value. `samples` are arguments, rising, and values, at least one. It begins at the
/// sample around which the mean is greatest. A parabola is fitted by least squares to what is
/// within 1.5 `reach`, and moves to its own summit until that rests. Samples fade out toward the
/// ends. So neither one sample's noise nor where samples begin moves it much. O(n^2).
Extreme greatest(const std::vector<Vec2>& samples, double reach);

}  // namespace toile
