#include "pattern/doubled_triangles.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace toile {

std::vector<int> doubled_triangles(const PanelMesh& garment) {
  std::vector<int> node(garment.flat.size());
  std::iota(node.begin(), node.end(), 0);
  const auto root = [&](int i) {
    while (node[static_cast<std::size_t>(i)] != i) {
      // Halving the path keeps long chains of seams short.
      int& up = node[static_cast<std::size_t>(i)];
      up = node[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  std::vector<bool> sewn(garment.flat.size(), false);
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      node[static_cast<std::size_t>(root(seam.a[i]))] = root(seam.b[i]);
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
    for (int& corner : nodes) corner = root(corner);
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
