// Cloth that is held farther off the body than its offset.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace toile {

struct ExtraOffset {
  std::ptrdiff_t nodes = 0;
  double max = 0;  ///< metres
};

/// Of DressResult::extra_offset.
inline ExtraOffset extra_offset_of(const std::vector<double>& extra) {
  if (extra.empty()) return {};
  return {std::ranges::count_if(extra, [](double metres) { return metres > 0; }),
          std::ranges::max(extra)};
}

}  // namespace toile
