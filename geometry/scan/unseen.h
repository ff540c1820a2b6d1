// How far a place is from what a scan saw.
#pragma once

#include <vector>

#include "geometry/scan/scan_cells.h"

namespace toile {

/// 0 near samples of the seen surface, 1 farther than `reach` from all, with two derivatives.
class Unseen {
 public:
  /// `samples` are one or more, `reach` is some spacings of them.
  Unseen(const std::vector<Vec3>& samples, double reach);

  /// O(samples within `reach`).
  double operator()(const Vec3& point) const;
  /// Whether no sample is within `reach`.
  bool is_far(const Vec3& point) const;

 private:
  std::vector<Vec3> samples_;  // cell by cell
  ScanCells cells_;
  std::vector<int> first_;  // of each cell, and the end
  double reach_;
};

}  // namespace toile
