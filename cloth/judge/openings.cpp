#include "cloth/judge/openings.h"

#include <map>
#include <utility>

#include "geometry/border_loops.h"
#include "geometry/disjoint_sets.h"

namespace toile {

std::vector<int> connected_pieces(const DressedGarment& dressed) {
  DisjointSets sets(dressed.points.size());
  std::vector<char> is_used(dressed.points.size(), 0);
  for (const Triangle& t : dressed.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
    for (const int p : t) is_used[p] = 1;
  }
  std::vector<int> piece(dressed.points.size(), -1);
  std::map<int, int> number;
  for (std::size_t p = 0; p < piece.size(); ++p) {
    if (!is_used[p]) continue;
    piece[p] =
        number.emplace(sets.of(static_cast<int>(p)), static_cast<int>(number.size())).first->second;
  }
  return piece;
}

std::vector<Opening> find_openings(const DressedGarment& dressed, const Skeleton& skeleton) {
  const std::vector<int> piece = connected_pieces(dressed);
  std::vector<std::vector<int>> loops = border_loops(dressed.triangles, dressed.points.size());
  // Of each border edge, its flat length and its panel.
  std::map<std::pair<int, int>, std::pair<double, int>> edges;
  for (const std::vector<int>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges[std::minmax(loop[i], loop[(i + 1) % loop.size()])] = {};
    }
  }
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const auto edge = edges.find(std::minmax(dressed.triangles[t][i], dressed.triangles[t][j]));
      if (edge == edges.end()) continue;
      const Triangle& flat = dressed.flat_triangles[t];
      edge->second = {(dressed.flat[flat[i]] - dressed.flat[flat[j]]).norm(),
                      dressed.panel_of_triangle[t]};
    }
  }
  std::vector<Opening> openings;
  for (std::vector<int>& loop : loops) {
    Opening opening;
    std::vector<Vec3> curve;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [length, panel] = edges.at(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
      opening.length += length;
      opening.panels.push_back(panel);
      curve.push_back(dressed.points[loop[i]]);
      opening.middle += curve.back() / static_cast<double>(loop.size());
    }
    opening.limbs = limbs_through(curve, skeleton);
    opening.component = piece[loop.front()];
    opening.nodes = std::move(loop);
    openings.push_back(std::move(opening));
  }
  return openings;
}

}  // namespace toile
