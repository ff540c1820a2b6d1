#include "cloth/judge/yarn_strain.h"

#include <algorithm>
#include <cmath>

#include "cloth/model/gathers.h"

namespace toile {

std::vector<YarnStrain> yarn_strains(const PanelMesh& garment, const std::vector<Vec3>& points) {
  std::vector<YarnStrain> strains(garment.triangles.size());
  for (const MeshedPanel& panel : garment.panels) {
    const auto [weft, warp] = yarn_directions(panel.grain);
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      const Triangle& corners = garment.triangles[t];
      const Vec2 flat_b = garment.flat[corners[1]] - garment.flat[corners[0]];
      const Vec2 flat_c = garment.flat[corners[2]] - garment.flat[corners[0]];
      const Vec3 b = points[corners[1]] - points[corners[0]];
      const Vec3 c = points[corners[2]] - points[corners[0]];
      const double twice_area = flat_b.x() * flat_c.y() - flat_b.y() * flat_c.x();
      // The vector in space that a unit vector of the flat panel has become.
      const auto mapped = [&](const Vec2& yarn) {
        return Vec3(((yarn.x() * flat_c.y() - yarn.y() * flat_c.x()) * b +
                     (yarn.y() * flat_b.x() - yarn.x() * flat_b.y()) * c) /
                    twice_area);
      };
      const Vec3 u = mapped(weft);
      const Vec3 v = mapped(warp);
      const double lengths = u.norm() * v.norm();
      const double sine = lengths > 0 ? std::clamp(u.dot(v) / lengths, -1.0, 1.0) : 0;
      strains[t] = {u.norm() - 1, v.norm() - 1, std::asin(sine)};
    }
  }
  return strains;
}

std::vector<char> on_gathers(const PanelMesh& garment) {
  std::vector<char> on(garment.triangles.size(), 0);
  for (const auto& [triangle, along] : gathered_rows(garment, gathered_edges(garment))) {
    on[triangle] = 1;
  }
  return on;
}

}  // namespace toile
