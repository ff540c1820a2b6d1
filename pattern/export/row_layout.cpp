#include "pattern/export/row_layout.h"

#include <algorithm>
#include <numeric>

namespace toile {

namespace {

RowLayout rows_of(const std::vector<Vec2>& sizes, const std::vector<std::size_t>& order, double gap,
                  double width) {
  RowLayout layout;
  layout.corners.resize(sizes.size());
  Vec2 next(gap, -gap);  // the upper left corner of the next box; y = 0 is the top
  double row_height = 0;
  for (const std::size_t i : order) {
    if (next.x() > gap && next.x() + sizes[i].x() + gap > width) {
      next = {gap, next.y() - row_height - gap};
      row_height = 0;
    }
    layout.corners[i] = {next.x(), next.y() - sizes[i].y()};
    next.x() += sizes[i].x() + gap;
    row_height = std::max(row_height, sizes[i].y());
    layout.size.x() = std::max(layout.size.x(), next.x());
  }
  layout.size.y() = row_height + gap - next.y();
  for (Vec2& corner : layout.corners) corner.y() += layout.size.y();
  return layout;
}

}  // namespace

RowLayout lay_out_rows(const std::vector<Vec2>& sizes, double gap, double width,
                       double max_height) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sizes[a].y() > sizes[b].y() + 1e-6;
  });
  double longest = width;
  double all = gap;  // the width with which there is one row
  for (const Vec2& size : sizes) {
    longest = std::max(longest, size.x() + 2 * gap);
    all += size.x() + gap;
  }
  RowLayout layout = rows_of(sizes, order, gap, longest);
  while (layout.size.y() > max_height && layout.size.x() < layout.size.y() && longest < all) {
    longest *= 1.25;
    layout = rows_of(sizes, order, gap, longest);
  }
  return layout;
}

}  // namespace toile
