// A garment mesh as it is once sewn, for tests of what the sewing makes of it.
#pragma once

#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile::samples {

/// The node of each material point when all seams are sewn.
inline std::vector<int> sewn_nodes(const PanelMesh& garment) {
  std::vector<int> parent(garment.flat.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const int a = root(seam.a[i]);
      const int b = root(seam.b[i]);
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = root(static_cast<int>(i));
  return parent;
}

/// The triangles of the level that is `coarser` levels above the finest.
inline std::vector<Triangle> triangles_of_level(const PanelMesh& garment, int coarser) {
  std::vector<Triangle> triangles = garment.triangles;
  for (int level = 0; level < coarser; ++level) {
    std::vector<Triangle> parents;
    for (std::size_t t = 0; t < triangles.size(); t += 4) {
      parents.push_back({triangles[t][0], triangles[t + 1][1], triangles[t + 2][2]});
    }
    triangles = std::move(parents);
  }
  return triangles;
}

/// The first fault that keeps the sewn garment from being an oriented surface; empty when there is
/// none. Faults are a triangle with two corners in one node, and an edge passed twice in the same
/// direction.
inline std::string sewn_fault(const PanelMesh& garment, int coarser) {
  const std::vector<int> node = sewn_nodes(garment);
  std::set<std::array<int, 2>> runs;
  for (const Triangle& triangle : triangles_of_level(garment, coarser)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = node[static_cast<std::size_t>(triangle[k])];
      const int b = node[static_cast<std::size_t>(triangle[(k + 1) % 3])];
      if (a == b) return "two corners in node " + std::to_string(a);
      if (!runs.insert({a, b}).second) {
        return "edge " + std::to_string(a) + "-" + std::to_string(b) + " twice";
      }
    }
  }
  return "";
}

}  // namespace toile::samples
