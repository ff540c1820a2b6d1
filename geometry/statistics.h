// The median, percentiles and root mean square of plain lists of numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace toile {

/// The value at index floor(n / 2) of the n `values` in rising order. For an even n this is the
/// upper of the two values in the middle. 0 for no values. O(n).
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The value at index floor(share (n - 1)) of the n `values` in rising order, without
/// interpolation. `share` is in [0, 1]. 0 for no values. O(n).
inline double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The root of the mean of the squares, summed in the order of `values`. Not a number for no
/// values.
inline double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace toile
