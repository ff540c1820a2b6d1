#include "cloth/contact/box_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cloth/contact/constants.h"
#include "geometry/vec4.h"

namespace toile {

namespace {

/// Boxes that are compared at a time.
constexpr std::size_t width = 8;
using Lanes = float __attribute__((vector_size(32), aligned(4), may_alias));
using LaneMasks = int __attribute__((vector_size(32)));

/// Share of the largest coordinate: a hundred times what single precision rounds off.
constexpr double rounding = 4e-6;

[[gnu::always_inline]] inline const Lanes& lanes(const float* at) {
  return *reinterpret_cast<const Lanes*>(at);
}

}  // namespace

BoxGrid::BoxGrid(const std::vector<Shape>& shapes, double reach) : reach_(reach) {
  low_ = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low_;
  double sum = 0;
  for (const Shape& shape : shapes) {
    low_ = low_.cwiseMin(shape.centre);
    high = high.cwiseMax(shape.centre);
    sum += shape.radius;
  }
  if (shapes.empty()) low_ = high = Vec3::Zero();
  const double max_radius = large_sphere_ratio * sum / std::max<std::size_t>(shapes.size(), 1);
  cell_ = std::max(0.5 * (2 * max_radius + reach), 1e-6);
  const double max_cells = max_cells_per_sphere * static_cast<double>(shapes.size()) + 1;
  while (((high - low_) / cell_ + Vec3::Ones()).prod() > max_cells) cell_ *= cell_growth;
  for (int axis = 0; axis < 3; ++axis) {
    size_[axis] = static_cast<int>((high[axis] - low_[axis]) / cell_) + 1;
  }
  first_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
  filed_radius_ = 0;
  double largest_radius = 0;
  constexpr std::size_t no_cell = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> cell_of(shapes.size(), no_cell);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    largest_radius = std::max(largest_radius, shapes[i].radius);
    if (shapes[i].radius > max_radius) continue;
    filed_radius_ = std::max(filed_radius_, shapes[i].radius);
    const Vec3& c = shapes[i].centre;
    cell_of[i] = static_cast<std::size_t>(row(column(c[1], 1), column(c[2], 2))) * size_[0] +
                 column(c[0], 0);
    ++first_[cell_of[i] + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  const double largest = std::max(low_.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  margin_ = rounding * (largest + largest_radius + reach);
  numbers_.resize(shapes.size());
  rows_.resize(shapes.size());
  for (int axis = 0; axis < 3; ++axis) {
    lows_[axis].resize(shapes.size() + width);
    highs_[axis].resize(shapes.size() + width);
  }
  std::vector<int> next(first_.begin(), first_.end() - 1);
  int large = first_.back();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const bool is_large = cell_of[i] == no_cell;
    const int at = is_large ? large++ : next[cell_of[i]]++;
    numbers_[at] = static_cast<int>(i);
    rows_[at] = is_large ? size_[1] * size_[2] : static_cast<int>(cell_of[i] / size_[0]);
    for (int axis = 0; axis < 3; ++axis) {
      lows_[axis][at] = static_cast<float>(shapes[i].box.low[axis] - margin_);
      highs_[axis][at] = static_cast<float>(shapes[i].box.high[axis] + margin_);
    }
  }
}

BoxGrid::FloatBox BoxGrid::widened(const Box& box) const {
  FloatBox result;
  for (int axis = 0; axis < 3; ++axis) {
    result.low[axis] = static_cast<float>(box.low[axis] - reach_);
    result.high[axis] = static_cast<float>(box.high[axis] + reach_);
  }
  return result;
}

BoxGrid::FloatBox BoxGrid::widened(std::size_t item) const {
  FloatBox result;
  for (int axis = 0; axis < 3; ++axis) {
    result.low[axis] = static_cast<float>(lows_[axis][item] - reach_);
    result.high[axis] = static_cast<float>(highs_[axis][item] + reach_);
  }
  return result;
}

int BoxGrid::column(double coordinate, int axis) const {
  return static_cast<int>(std::clamp((coordinate - low_[axis]) / cell_, 0.0, size_[axis] - 1.0));
}

/// All indices are written, and those that do not meet the box overwritten: that takes no branch.
[[gnu::always_inline]] inline std::size_t BoxGrid::collect(std::size_t begin, std::size_t end,
                                                           const FloatBox& box, std::size_t count,
                                                           Scratch& found) const {
  if (begin >= end) return count;
  constexpr LaneMasks places = {0, 1, 2, 3, 4, 5, 6, 7};
  if (found.size() < count + (end - begin) + width) found.resize(2 * (count + end - begin) + width);
  int* const out = found.data();
  for (std::size_t i = begin; i < end; i += width) {
    LaneMasks met = places < static_cast<int>(std::min(end - i, width));
    for (int axis = 0; axis < 3; ++axis) {
      met &= lanes(&lows_[axis][i]) <= box.high[axis];
      met &= lanes(&highs_[axis][i]) >= box.low[axis];
    }
    for (std::size_t lane = 0; lane < width; ++lane) {
      out[count] = static_cast<int>(i + lane);
      count -= met[lane];
    }
  }
  return count;
}

TOILE_CLONES
std::size_t BoxGrid::meeting(std::size_t start, int first_row, const FloatBox& box,
                             Scratch& found) const {
  // An item whose box meets this one has its centre not much farther.
  const double around = filed_radius_ + margin_;
  const int x0 = column(box.low[0] - around, 0);
  const int x1 = column(box.high[0] + around, 0);
  const int y0 = column(box.low[1] - around, 1);
  const int y1 = column(box.high[1] + around, 1);
  const int z1 = column(box.high[2] + around, 2);
  std::size_t count = 0;
  const int z0 = std::max(column(box.low[2] - around, 2), first_row / size_[1]);
  for (int z = z0; z <= z1; ++z) {
    for (int y = std::max(y0, first_row - row(0, z)); y <= y1; ++y) {
      const std::size_t cells = static_cast<std::size_t>(row(y, z)) * size_[0];
      const auto begin = static_cast<std::size_t>(first_[cells + x0]);
      const auto end = static_cast<std::size_t>(first_[cells + x1 + 1]);
      count = collect(std::max(begin, start), end, box, count, found);
    }
  }
  // Large shapes are in no cell.
  const auto filed = static_cast<std::size_t>(first_.back());
  return collect(std::max(filed, start), numbers_.size(), box, count, found);
}

}  // namespace toile
