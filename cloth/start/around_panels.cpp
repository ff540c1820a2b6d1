#include "cloth/start/around_panels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloth/start/constants.h"

namespace toile {

namespace {

/// Metres: how wide the panel is in the mean across a seam of this length, and at most its size.
double width_across(const PanelMesh& garment, const MeshedPanel& panel, double length) {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = -low;
  for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
    low = low.cwiseMin(garment.flat[i]);
    high = high.cwiseMax(garment.flat[i]);
  }
  double area = 0;
  for (const Triangle& triangle : garment.triangles) {
    if (triangle[0] < panel.first_point || triangle[0] >= panel.first_point + panel.points) {
      continue;
    }
    const Vec2 a = garment.flat[triangle[1]] - garment.flat[triangle[0]];
    const Vec2 b = garment.flat[triangle[2]] - garment.flat[triangle[0]];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return std::min((high - low).maxCoeff(), area / std::max(length, 1e-9));
}

}  // namespace

bool closes_around(const PanelMesh& garment, int panel) {
  const std::vector<int> panel_of = panel_of_points(garment);
  return std::ranges::any_of(garment.seams, [&](const MeshedSeam& seam) {
    if (panel_of[seam.a[1]] != panel || panel_of[seam.b[1]] != panel) return false;
    if (seam.a.front() == seam.b.front() || seam.a.back() == seam.b.back()) return false;
    double gap = 0;
    double length = 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      gap += (garment.flat[seam.a[i]] - garment.flat[seam.b[i]]).norm();
      if (i > 0) length += (garment.flat[seam.a[i]] - garment.flat[seam.a[i - 1]]).norm();
    }
    return gap / static_cast<double>(seam.a.size()) >
           min_around_gap * width_across(garment, garment.panels[panel], length);
  });
}

PlacementAxis up_axis(const PanelMesh& garment, int panel, bool to_partners) {
  const std::vector<int> panel_of = panel_of_points(garment);
  const MeshedPanel& of = garment.panels[panel];
  Vec2 along(0, 1);
  for (const MeshedSeam& seam : garment.seams) {
    if (panel_of[seam.a[1]] != panel || panel_of[seam.b[1]] != panel) continue;
    const Vec2 run = garment.flat[seam.a.back()] - garment.flat[seam.a.front()];
    along = std::abs(run.x()) > std::abs(run.y()) ? Vec2(1, 0) : Vec2(0, 1);
    break;
  }
  Vec2 sewn = Vec2::Zero();
  Vec2 centre = Vec2::Zero();
  int count = 0;
  for (int i = of.first_point; i < of.first_point + of.points; ++i) {
    centre += garment.flat[i] / of.points;
  }
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const bool a_mine = panel_of[seam.a[i]] == panel;
      if (a_mine == (panel_of[seam.b[i]] == panel)) continue;
      sewn += garment.flat[a_mine ? seam.a[i] : seam.b[i]] - centre;
      ++count;
    }
  }
  const double up = to_partners && count > 0 ? sewn.dot(along) : 1;
  if (along.x() > 0) return up < 0 ? PlacementAxis::minus_x : PlacementAxis::plus_x;
  return up < 0 ? PlacementAxis::minus_y : PlacementAxis::plus_y;
}

}  // namespace toile
