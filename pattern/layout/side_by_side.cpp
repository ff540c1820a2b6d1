#include "pattern/layout/side_by_side.h"

#include <Eigen/Geometry>

#include "pattern/layout/row_layout.h"

namespace toile {

namespace {

/// Metres between panels that lie side by side: enough for a name.
constexpr double between_panels = 0.04;

}  // namespace

SideBySide side_by_side(const DressedGarment& garment) {
  std::vector<int> panel_of(garment.flat.size(), 0);
  for (std::size_t t = 0; t < garment.flat_triangles.size(); ++t) {
    for (const int point : garment.flat_triangles[t]) {
      panel_of[point] = garment.panel_of_triangle[t];
    }
  }
  std::vector<Eigen::AlignedBox2d> boxes(garment.panels.size());
  for (std::size_t i = 0; i < garment.flat.size(); ++i) boxes[panel_of[i]].extend(garment.flat[i]);
  std::vector<Vec2> sizes;
  for (const Eigen::AlignedBox2d& box : boxes) {
    sizes.push_back(box.isEmpty() ? Vec2(0, 0) : Vec2(box.sizes()));
  }
  const RowLayout layout = lay_out_rows(sizes, between_panels, 0, 0);  // about square
  SideBySide laid{garment.flat, layout.size};
  for (std::size_t i = 0; i < laid.flat.size(); ++i) {
    laid.flat[i] += layout.corners[panel_of[i]] - boxes[panel_of[i]].min();
  }
  return laid;
}

}  // namespace toile
