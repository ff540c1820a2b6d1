#include "cloth/dressing/panels_over.h"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>

#include "cloth/dressing/constants.h"
#include "geometry/error.h"

namespace toile {

namespace {

Vec3 turned_out(const DistanceGrid& below, const DistanceGrid& above, const Vec3& p) {
  const DistanceGrid::Sample at = below.at(p);
  const double length = at.gradient.norm();
  if (length < 1e-6) return p;
  const Vec3 out = at.gradient / length;
  double way = 0;
  for (int i = 0; i < max_flip_steps; ++i) {
    const double missing = at.distance - above.at(p + way * out).distance;
    if (std::abs(missing) < flip_tolerance) break;
    way = std::min(std::max(way + missing, 0.0), max_flip_distance);
  }
  return p + way * out;
}

}  // namespace

std::vector<int> panels_named(const PanelMesh& garment, const std::vector<std::string>& patterns) {
  std::vector<char> is_named(garment.panels.size(), 0);
  for (const std::string& pattern : patterns) {
    bool any = false;
    for (std::size_t p = 0; p < garment.panels.size(); ++p) {
      if (fnmatch(pattern.c_str(), garment.panels[p].name.c_str(), 0) != 0) continue;
      is_named[p] = 1;
      any = true;
    }
    if (any) continue;
    std::string names;
    for (const MeshedPanel& panel : garment.panels) names += " " + panel.name;
    throw Error("panels_over", "no panel is called '" + pattern + "'", "there are" + names);
  }
  std::vector<int> panels;
  for (std::size_t p = 0; p < is_named.size(); ++p) {
    if (is_named[p] != 0) panels.push_back(static_cast<int>(p));
  }
  return panels;
}

void leave_out(const PanelMesh& garment, const std::vector<int>& panels,
               std::vector<Triangle>& triangles) {
  std::vector<char> is_left_out(triangles.size(), 0);
  for (const int panel : panels) {
    const MeshedPanel& meshed = garment.panels[panel];
    std::fill_n(is_left_out.begin() + meshed.first_triangle, meshed.triangles, 1);
  }
  std::size_t t = 0;
  std::erase_if(triangles, [&](const Triangle&) { return is_left_out[t++] != 0; });
}

std::vector<char> flip_over(const PanelMesh& garment, const std::vector<int>& panels,
                            const DistanceGrid& below, const DistanceGrid& above,
                            const std::vector<Triangle>& triangles, std::vector<Vec3>& nodes) {
  std::vector<char> of_panels(nodes.size(), 0);
  for (const int panel : panels) {
    const MeshedPanel& meshed = garment.panels[panel];
    for (int t = meshed.first_triangle; t < meshed.first_triangle + meshed.triangles; ++t) {
      for (const int node : triangles[t]) of_panels[node] = 1;
    }
  }
  std::vector<char> moved(nodes.size(), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (of_panels[n] == 0) continue;
    const Vec3 to = turned_out(below, above, nodes[n]);
    moved[n] = (to - nodes[n]).norm() > flip_tolerance;
    nodes[n] = to;
  }
  return moved;
}

}  // namespace toile
