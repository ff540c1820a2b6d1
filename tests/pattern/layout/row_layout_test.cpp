#include "pattern/layout/row_layout.h"

#include <gtest/gtest.h>

namespace toile {
namespace row_layout_test {

TEST(RowLayout, BoxesLieApartWithinTheSheet) {
  std::vector<Vec2> sizes;
  for (int i = 0; i < 23; ++i)
    sizes.push_back({0.1 + 0.05 * (i * 7 % 9), 0.1 + 0.06 * (i * 5 % 11)});
  const double gap = 0.02;
  const RowLayout layout = lay_out_rows(sizes, gap, 1.5, 5);
  EXPECT_LE(layout.size.x(), 1.5 + 1e-12);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Vec2 low = layout.corners[i];
    const Vec2 high = low + sizes[i];
    EXPECT_GE(low.minCoeff(), gap - 1e-12);
    EXPECT_LE((high - layout.size).maxCoeff(), -gap + 1e-12);
    for (std::size_t k = 0; k < i; ++k) {
      const Vec2 apart = (layout.corners[k] - high).cwiseMax(low - layout.corners[k] - sizes[k]);
      EXPECT_GE(apart.maxCoeff(), gap - 1e-12) << i << " and " << k;
    }
  }
}

TEST(RowLayout, RowsGrowWhereTheSheetWouldBeTooHigh) {
  const std::vector<Vec2> sizes(60, Vec2(0.7, 0.9));
  EXPECT_GT(lay_out_rows(sizes, 0.02, 1.5, 100).size.y(), 20);
  const RowLayout layout = lay_out_rows(sizes, 0.02, 1.5, 5);
  EXPECT_LE(layout.size.y(), layout.size.x());
  // One tall box and one row are as they are.
  EXPECT_NEAR(lay_out_rows({{1, 6}}, 0.02, 1.5, 5).size.y(), 6.04, 1e-12);
  EXPECT_NEAR(lay_out_rows({{1, 9}, {1, 8}}, 0.02, 1.5, 5).size.y(), 9.04, 1e-12);
  // A box that is wider than a row makes the row.
  EXPECT_NEAR(lay_out_rows({{3, 1}}, 0.02, 1.5, 5).size.x(), 3.04, 1e-12);
}

}  // namespace row_layout_test
}  // namespace toile
