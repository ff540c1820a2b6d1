#include "geometry/body/open_crossings.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/adjacency.h"
#include "geometry/half_edges.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// max_crease_move ends the search before, where the smoothed part is small.
constexpr int max_rounds = 60;
constexpr int first_rings = 2;
constexpr int rounds_of_ring = 4;

}  // namespace

OpenedCrossings open_crossings(TriangleMesh& mesh) {
  std::vector<TrianglePair> pairs = self_intersections(mesh);
  OpenedCrossings result;
  result.pairs_before = result.pairs_left = static_cast<int>(pairs.size());
  if (pairs.empty()) return result;

  const std::vector<std::array<int, 2>> edges = unique_edges(mesh.triangles);
  const Adjacency<int> neighbours(mesh.points.size(), [&edges](const auto& add) {
    for (const auto& [a, b] : edges) {
      add(a, b);
      add(b, a);
    }
  });
  const std::vector<Vec3> before = mesh.points;
  std::vector<bool> is_marked(mesh.points.size(), false);
  std::vector<int> marked;
  const auto mark = [&](int point) {
    if (is_marked[point]) return;
    is_marked[point] = true;
    marked.push_back(point);
  };
  double largest = 0;
  for (int round = 0; round < max_rounds && !pairs.empty(); ++round) {
    for (const TrianglePair& pair : pairs) {
      for (const int triangle : pair) {
        for (const int corner : mesh.triangles[triangle]) mark(corner);
      }
    }
    const int rings = round == 0 ? first_rings : (round % rounds_of_ring == 0 ? 1 : 0);
    for (int ring = 0; ring < rings; ++ring) {
      const std::size_t count = marked.size();
      for (std::size_t k = 0; k < count; ++k) {
        for (const int next : neighbours[marked[k]]) mark(next);
      }
    }
    std::vector<std::pair<int, Vec3>> smoothed;
    smoothed.reserve(marked.size());
    for (const int point : marked) {
      Vec3 mean = Vec3::Zero();
      for (const int next : neighbours[point]) mean += mesh.points[next];
      mean /= static_cast<double>(neighbours[point].size());
      smoothed.emplace_back(point, (mesh.points[point] + mean) / 2);
    }
    for (const auto& [point, place] : smoothed) mesh.points[point] = place;
    for (const int point : marked) {
      largest = std::max(largest, (mesh.points[point] - before[point]).norm());
    }
    if (largest > max_crease_move) break;
    pairs = self_intersections(mesh);
  }
  if (!pairs.empty()) {
    mesh.points = before;
    return result;
  }
  result.pairs_left = 0;
  result.largest_move = largest;
  return result;
}

}  // namespace toile
