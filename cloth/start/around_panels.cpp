#include "cloth/start/around_panels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloth/start/constants.h"

namespace toile {

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
