#include "cloth/judge/on_floor.h"

#include <algorithm>
#include <cstddef>

namespace toile {

std::vector<std::string> panels_on_floor(const PanelMesh& garment, const DressedGarment& dressed,
                                         double height) {
  std::vector<char> lies(garment.panels.size(), 0);
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    const bool is_low = std::ranges::any_of(
        dressed.triangles[t], [&](int node) { return dressed.points[node].y() <= height; });
    if (is_low) lies[dressed.panel_of_triangle[t]] = 1;
  }
  std::vector<std::string> names;
  names.reserve(lies.size());
  for (std::size_t p = 0; p < lies.size(); ++p) {
    if (lies[p] != 0) names.push_back(garment.panels[p].name);
  }
  return names;
}

}  // namespace toile
