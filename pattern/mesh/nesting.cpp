#include "pattern/mesh/nesting.h"

#include <algorithm>
#include <map>
#include <vector>

namespace toile {

namespace {

/// Replaces the triangles of one panel by those of the next coarser level. False when they are not
/// runs of four.
bool coarsen(std::vector<Triangle>& triangles) {
  if (triangles.empty() || triangles.size() % 4 != 0) return false;
  std::map<std::array<int, 2>, int> middles;
  std::vector<Triangle> coarse;
  for (std::size_t t = 0; t < triangles.size(); t += 4) {
    const Triangle& centre = triangles[t + 3];
    const auto [m01, m12, m20] = centre;
    const Triangle parent = {triangles[t][0], triangles[t + 1][1], triangles[t + 2][2]};
    const auto [c0, c1, c2] = parent;
    if (triangles[t] != Triangle{c0, m01, m20} || triangles[t + 1] != Triangle{m01, c1, m12} ||
        triangles[t + 2] != Triangle{m20, m12, c2}) {
      return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = parent[k];
      const int b = parent[(k + 1) % 3];
      const auto [found, added] = middles.try_emplace({std::min(a, b), std::max(a, b)}, centre[k]);
      if (!added && found->second != centre[k]) return false;
    }
    coarse.push_back(parent);
  }
  triangles = std::move(coarse);
  return true;
}

/// The number of points that `triangles` use if these are first, first + 1, ... without a gap; else
/// -1.
int points_used(const std::vector<Triangle>& triangles, int first, int points) {
  std::vector<bool> used(points, false);
  int highest = 0;
  int count = 0;
  for (const Triangle& triangle : triangles) {
    for (const int corner : triangle) {
      const int index = corner - first;
      highest = std::max(highest, index + 1);
      if (!used[index]) ++count;
      used[index] = true;
    }
  }
  return count == highest ? count : -1;
}

}  // namespace

std::optional<std::string> nesting_problem(const PanelMesh& garment) {
  if (garment.subdivisions == 0) return std::nullopt;
  if (garment.subdivisions < 0 || garment.subdivisions > 10) {
    return "states " + std::to_string(garment.subdivisions) + " subdivisions";
  }
  // Per material point, the coarsest level that it belongs to; 0 is the finest.
  std::vector<int> level_of(garment.flat.size(), 0);
  for (const MeshedPanel& panel : garment.panels) {
    const auto begin = garment.triangles.begin() + panel.first_triangle;
    std::vector<Triangle> triangles(begin, begin + panel.triangles);
    int points = panel.points;
    for (int level = 1; level <= garment.subdivisions; ++level) {
      if (!coarsen(triangles)) {
        return "states " + std::to_string(garment.subdivisions) + " subdivisions, but panel '" +
               panel.name + "' is not subdivided so";
      }
      const int coarser = points_used(triangles, panel.first_point, points);
      if (coarser < 0) {
        return "panel '" + panel.name + "' has points of a finer level before coarser ones";
      }
      points = coarser;
      std::fill_n(level_of.begin() + panel.first_point, points, level);
    }
  }
  const std::size_t stride = std::size_t{1} << garment.subdivisions;
  const auto nested = [&](const std::vector<int>& along) {
    bool follows = (along.size() - 1) % stride == 0;
    for (std::size_t i = 0; i < along.size() && follows; ++i) {
      int level = 0;
      while (level < garment.subdivisions && i % (std::size_t{2} << level) == 0) ++level;
      follows = level_of[along[i]] == level;
    }
    return follows;
  };
  for (const MeshedSeam& seam : garment.seams) {
    if (!nested(seam.a) || !nested(seam.b)) {
      return "seam '" + seam.name + "' does not follow the subdivision";
    }
  }
  for (const MeshedElastic& elastic : garment.elastics) {
    if (!nested(elastic.points)) {
      return "elastic '" + elastic.name + "' does not follow the subdivision";
    }
  }
  for (const MeshedAttachment& attached : garment.attachments) {
    if (!nested(attached.points)) {
      return "attachment '" + attached.name + "' does not follow the subdivision";
    }
  }
  return std::nullopt;
}

}  // namespace toile
