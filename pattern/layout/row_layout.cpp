#include "pattern/layout/row_layout.h"

#include <algorithm>
#include <numeric>

namespace toile {

namespace {

RowLayout rows_of(const std::vector<Vec2>& sizes, const std::vector<std::size_t>& order, double gap,
                  double width) {
  RowLayout layout;
  layout.corners.resize(sizes.size());
  RowFiller rows(gap, gap, width);  // down from the top
  for (const std::size_t i : order) {
    const Vec2 from_top = rows.add(sizes[i]);
    layout.corners[i] = {from_top.x(), -(from_top.y() + sizes[i].y())};
  }
  layout.size = rows.size();
  for (Vec2& corner : layout.corners) corner.y() += layout.size.y();
  return layout;
}

}  // namespace

Vec2 RowFiller::add(const Vec2& size) {
  if (next_.x() > border_ && next_.x() + size.x() + border_ > width_) {
    next_ = {border_, next_.y() + row_height_ + gap_};
    row_height_ = 0;
  }
  Vec2 corner = next_;
  next_.x() += size.x() + gap_;
  row_height_ = std::max(row_height_, size.y());
  longest_ = std::max(longest_, next_.x());
  return corner;
}

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
