// A uniform grid in the plane that finds the points and segments near a point.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Numbers of shapes, filed under the square cells that the shapes' boxes meet. Adding a shape
/// costs the number of cells met. A visit costs the number of cells within reach and of their
/// entries.
class BucketGrid {
 public:
  /// Covers the box from `low` to `high` with cells `cell` metres wide. The cells are wider where
  /// the box would have more than 2000 of them along an axis. Points outside the box belong to the
  /// nearest cell.
  BucketGrid(const Vec2& low, const Vec2& high, double cell) : low_(low), cell_(cell) {
    constexpr double max_cells = 2000;  // along each axis
    cell_ = std::max(cell_, (high - low).maxCoeff() / max_cells);
    columns_ = static_cast<int>((high.x() - low.x()) / cell_) + 1;
    rows_ = static_cast<int>((high.y() - low.y()) / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }

  /// Files `number` under the cells that the box of the segment from `from` to `to` meets.
  void add(const Vec2& from, const Vec2& to, int number) {
    each_cell(from.cwiseMin(to), from.cwiseMax(to),
              [&](std::size_t cell) { cells_[cell].push_back(number); });
  }
  void add(const Vec2& point, int number) { add(point, point, number); }

  /// Calls `visit` with each number whose box lies within `reach` metres of `point`, and with some
  /// others. A number that fills several cells comes several times.
  template <class Visit>
  void near(const Vec2& point, double reach, const Visit& visit) const {
    const Vec2 margin(reach, reach);
    each_cell(point - margin, point + margin, [&](std::size_t cell) {
      for (const int number : cells_[cell]) visit(number);
    });
  }

 private:
  int column(double x) const {
    return static_cast<int>(std::clamp((x - low_.x()) / cell_, 0.0, columns_ - 1.0));
  }
  int row(double y) const {
    return static_cast<int>(std::clamp((y - low_.y()) / cell_, 0.0, rows_ - 1.0));
  }
  template <class Visit>
  void each_cell(const Vec2& low, const Vec2& high, const Visit& visit) const {
    for (int r = row(low.y()); r <= row(high.y()); ++r) {
      for (int c = column(low.x()); c <= column(high.x()); ++c) {
        visit(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(c));
      }
    }
  }

  Vec2 low_;     // metres
  double cell_;  // metres
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<int>> cells_;
};

}  // namespace toile
