// A uniform grid in space that finds the shapes near another.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Shapes of about one size, filed by the centres of spheres around them. The few that are much
/// larger than the others are compared with every query.
class BoxGrid {
 public:
  /// A box in space, from `low` to `high` (metres).
  struct Box {
    Vec3 low;
    Vec3 high;
  };
  /// A shape: a sphere (metres) and a box that both contain it.
  struct Shape {
    Vec3 centre;
    double radius;
    Box box;
  };
  /// Memory for one query at a time, to be used again for the next ones.
  using Scratch = std::vector<int>;

  /// Files `shapes` for queries within `reach` metres of a box. O(n).
  BoxGrid(const std::vector<Shape>& shapes, double reach);

  /// Calls `visit` with the index of each shape whose box is less than the reach away from `box`
  /// along each axis. Some may be a few micrometres farther. The order depends on the shapes only.
  template <typename Visit>
  void near(const Box& box, Scratch& scratch, const Visit& visit) const {
    const std::size_t count = meeting(0, 0, widened(box), scratch);
    for (std::size_t i = 0; i < count; ++i) visit(numbers_[scratch[i]]);
  }

  /// Number of parts that all pairs of shapes fall into: one part per shape.
  std::size_t parts() const { return numbers_.size(); }

  /// Calls `visit` with the indices, the lower first, of two shapes whose boxes are near, as near()
  /// does, for each such pair of a part. Over all parts in [0, parts()), each pair comes once.
  template <typename Visit>
  void pairs(std::size_t part, Scratch& scratch, const Visit& visit) const {
    const std::size_t count = meeting(part + 1, rows_[part], widened(part), scratch);
    const int one = numbers_[part];
    for (std::size_t i = 0; i < count; ++i) {
      const int other = numbers_[scratch[i]];
      visit(std::min(one, other), std::max(one, other));
    }
  }

 private:
  /// Single precision, with a margin that is far above its rounding.
  struct FloatBox {
    std::array<float, 3> low;
    std::array<float, 3> high;
  };

  FloatBox widened(const Box& box) const;
  FloatBox widened(std::size_t item) const;
  /// Finds the items, of those from index `start` on, whose boxes meet `box`: their indices come
  /// first in `found`. None of them is in a row of cells before `first_row`. Returns their number.
  std::size_t meeting(std::size_t start, int first_row, const FloatBox& box, Scratch& found) const;
  std::size_t collect(std::size_t begin, std::size_t end, const FloatBox& box, std::size_t count,
                      Scratch& found) const;
  int column(double coordinate, int axis) const;
  /// The number of a row of cells along x. Its first cell is that times size_[0].
  int row(int y, int z) const { return z * size_[1] + y; }

  double reach_;
  double margin_;        // metres around each box, for rounding
  double filed_radius_;  // metres: the largest radius of a shape in a cell
  double cell_;
  Vec3 low_;
  int size_[3];
  std::vector<int> first_;  // per cell, the index of its first item
  // Items are shapes by cells, then the large ones.
  std::vector<int> numbers_;  // per item, the index of its shape
  std::vector<int> rows_;     // per item, the row of its cell; that of no cell for large ones
  std::array<std::vector<float>, 3> lows_;
  std::array<std::vector<float>, 3> highs_;
};

}  // namespace toile
