#include "cloth/gathers.h"

#include <algorithm>

namespace toile {

namespace {

/// Sides whose lengths differ by more than this are eased or gathered.
constexpr double gather_threshold = 0.02;

}  // namespace

GatheredEdges gathered_edges(const PanelMesh& garment) {
  GatheredEdges shares;
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i + 1 < seam.a.size(); ++i) {
      const std::pair<int, int> a = std::minmax(seam.a[i], seam.a[i + 1]);
      const std::pair<int, int> b = std::minmax(seam.b[i], seam.b[i + 1]);
      const double length_a = (garment.flat[a.first] - garment.flat[a.second]).norm();
      const double length_b = (garment.flat[b.first] - garment.flat[b.second]).norm();
      if (length_a > (1 + gather_threshold) * length_b) shares[a] = length_b / length_a;
      if (length_b > (1 + gather_threshold) * length_a) shares[b] = length_a / length_b;
    }
  }
  return shares;
}

}  // namespace toile
