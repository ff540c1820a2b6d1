#include "pattern/mesh/doubled_triangles.h"

#include <algorithm>
#include <map>

#include "geometry/disjoint_sets.h"

namespace toile {

std::vector<int> doubled_triangles(const PanelMesh& garment) {
  DisjointSets nodes_of(garment.flat.size());
  std::vector<bool> sewn(garment.flat.size(), false);
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      nodes_of.join(seam.a[i], seam.b[i]);
      sewn[static_cast<std::size_t>(seam.a[i])] = true;
      sewn[static_cast<std::size_t>(seam.b[i])] = true;
    }
  }
  std::map<Triangle, std::vector<int>> meeting;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    Triangle nodes = garment.triangles[t];
    if (!std::all_of(nodes.begin(), nodes.end(),
                     [&](int i) { return sewn[static_cast<std::size_t>(i)]; })) {
      continue;
    }
    for (int& corner : nodes) corner = nodes_of.of(corner);
    std::sort(nodes.begin(), nodes.end());
    meeting[nodes].push_back(static_cast<int>(t));
  }
  std::vector<int> doubled;
  for (const auto& [nodes, triangles] : meeting) {
    if (triangles.size() > 1) doubled.insert(doubled.end(), triangles.begin(), triangles.end());
  }
  std::sort(doubled.begin(), doubled.end());
  return doubled;
}

}  // namespace toile
