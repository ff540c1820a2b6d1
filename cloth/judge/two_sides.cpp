#include "cloth/judge/two_sides.h"

#include <algorithm>
#include <map>
#include <vector>

#include "geometry/disjoint_sets.h"

namespace toile {

std::optional<std::pair<std::string, std::string>> one_sided_seam(const PanelMesh& garment,
                                                                  const DressedGarment& dressed) {
  struct Beside {
    int triangle;
    bool forward;  // the triangle runs from the edge's lower node to the higher one
  };
  const auto panel_of = [&](const Beside& b) { return dressed.panel_of_triangle[b.triangle]; };
  std::map<std::pair<int, int>, std::vector<Beside>> edges;
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    if (garment.panels[dressed.panel_of_triangle[t]].layered) continue;
    for (int i = 0; i < 3; ++i) {
      const int from = dressed.triangles[t][i];
      const int to = dressed.triangles[t][(i + 1) % 3];
      edges[std::minmax(from, to)].push_back({static_cast<int>(t), from < to});
    }
  }
  // Each triangle is there with either face up. Cloth has one side where it meets itself turned.
  const int count = static_cast<int>(dressed.triangles.size());
  DisjointSets faces(2 * dressed.triangles.size());
  for (const bool at_seams : {false, true}) {
    for (const auto& [edge, beside] : edges) {
      if (beside.size() != 2) continue;
      const auto& [a, b] = std::pair(beside[0], beside[1]);
      if ((panel_of(a) != panel_of(b)) != at_seams) continue;
      const int turned = a.forward == b.forward ? count : 0;
      if (faces.of(a.triangle) == faces.of(b.triangle + count - turned)) {
        return std::pair(garment.panels[panel_of(a)].name, garment.panels[panel_of(b)].name);
      }
      faces.join(a.triangle, b.triangle + turned);
      faces.join(a.triangle + count, b.triangle + count - turned);
    }
  }
  return std::nullopt;
}

}  // namespace toile
