// Points gathered in the cells of a sparse grid, to average them and to find neighbours.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// The occupied cells of a grid of cubes, in the order of their places. O(n log n) to build.
class ScanCells {
 public:
  /// `points` are one or more and finite; `size` is the cubes' edge, in their unit. It is made
  /// larger where the points' box would be more than a million cells wide.
  ScanCells(const std::vector<Vec3>& points, double size);

  double size() const { return size_; }
  std::size_t cells() const { return keys_.size(); }
  const std::vector<Vec3>& means() const { return means_; }     ///< of each cell's points
  const std::vector<int>& counts() const { return counts_; }    ///< of each cell's points
  const std::vector<int>& cell_of() const { return cell_of_; }  ///< one cell a point

  /// Calls `visit` with each occupied cell that is at most `reach` cells from the one of `point`
  /// along each axis. O(reach^2 log n).
  template <class Visit>
  void near(const Vec3& point, int reach, const Visit& visit) const {
    const std::array<std::int64_t, 3> at = place(point);
    for (std::int64_t z = at[2] - reach; z <= at[2] + reach; ++z) {
      for (std::int64_t y = at[1] - reach; y <= at[1] + reach; ++y) {
        const std::uint64_t first = key({at[0] - reach, y, z});
        const std::uint64_t last = key({at[0] + reach, y, z});
        auto cell = std::lower_bound(keys_.begin(), keys_.end(), first);
        for (; cell != keys_.end() && *cell <= last; ++cell) {
          visit(static_cast<int>(cell - keys_.begin()));
        }
      }
    }
  }

 private:
  std::array<std::int64_t, 3> place(const Vec3& point) const;
  /// Cells along x follow each other.
  static std::uint64_t key(const std::array<std::int64_t, 3>& place);

  double size_;
  Vec3 origin_;
  std::vector<std::uint64_t> keys_;  // in rising order
  std::vector<Vec3> means_;
  std::vector<int> counts_;
  std::vector<int> cell_of_;
};

/// About the distance between neighbouring points of a scanned surface, in the points' unit. It is
/// the side of a square that holds one point, where half of the points are denser. 0 for less than
/// two places.
double point_spacing(const std::vector<Vec3>& points);

}  // namespace toile
