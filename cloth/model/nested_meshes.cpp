#include "cloth/model/nested_meshes.h"

#include <algorithm>
#include <numeric>

namespace toile {

namespace {

/// The coarse triangle t, which was split into the fine ones 4t to 4t + 3.
Triangle parent_of(const std::vector<Triangle>& fine, std::size_t t) {
  return {fine[4 * t][0], fine[4 * t + 1][1], fine[4 * t + 2][2]};
}

/// Per fine point, its index on the coarser level; -1: it is new on the finer one.
std::vector<int> coarse_index(const PanelMesh& fine) {
  std::vector<char> kept(fine.flat.size(), 0);
  for (std::size_t t = 0; t < fine.triangles.size() / 4; ++t) {
    for (const int point : parent_of(fine.triangles, t)) kept[point] = 1;
  }
  std::vector<int> index(fine.flat.size(), -1);
  int next = 0;
  for (std::size_t p = 0; p < kept.size(); ++p) {
    if (kept[p]) index[p] = next++;
  }
  return index;
}

std::vector<int> kept_of(const std::vector<int>& points, const std::vector<int>& index) {
  std::vector<int> kept;
  for (const int p : points) {
    if (index[p] >= 0) kept.push_back(index[p]);
  }
  return kept;
}

}  // namespace

PanelMesh coarsen(const PanelMesh& fine) {
  const std::vector<int> index = coarse_index(fine);
  PanelMesh coarse;
  coarse.subdivisions = fine.subdivisions - 1;
  coarse.edge_length = 2 * fine.edge_length;
  for (std::size_t p = 0; p < fine.flat.size(); ++p) {
    if (index[p] < 0) continue;
    coarse.flat.push_back(fine.flat[p]);
    coarse.placed.push_back(fine.placed[p]);
  }
  for (std::size_t t = 0; t < fine.triangles.size() / 4; ++t) {
    const Triangle parent = parent_of(fine.triangles, t);
    coarse.triangles.push_back({index[parent[0]], index[parent[1]], index[parent[2]]});
  }
  int first_point = 0;
  for (const MeshedPanel& panel : fine.panels) {
    MeshedPanel smaller = panel;
    smaller.first_point = first_point;
    smaller.points = static_cast<int>(std::count_if(
        index.begin() + panel.first_point, index.begin() + panel.first_point + panel.points,
        [](int i) { return i >= 0; }));
    smaller.first_triangle = panel.first_triangle / 4;
    smaller.triangles = panel.triangles / 4;
    first_point += smaller.points;
    coarse.panels.push_back(smaller);
  }
  for (const MeshedSeam& seam : fine.seams) {
    MeshedSeam thinned = seam;
    thinned.a = kept_of(seam.a, index);
    thinned.b = kept_of(seam.b, index);
    coarse.seams.push_back(thinned);
  }
  for (const MeshedElastic& elastic : fine.elastics) {
    MeshedElastic thinned = elastic;
    thinned.points = kept_of(elastic.points, index);
    coarse.elastics.push_back(thinned);
  }
  for (const MeshedAttachment& attached : fine.attachments) {
    MeshedAttachment thinned = attached;
    thinned.points = kept_of(attached.points, index);
    coarse.attachments.push_back(thinned);
  }
  return coarse;
}

void leave_open(std::vector<PanelMesh>& meshes, std::vector<char> unsewn) {
  meshes.back().unsewn = std::move(unsewn);
  for (std::size_t depth = meshes.size() - 1; depth > 0; --depth) {
    const PanelMesh& coarse = meshes[depth];
    PanelMesh& fine = meshes[depth - 1];
    fine.unsewn.assign(fine.flat.size(), 0);
    for (std::size_t t = 0; t < coarse.triangles.size(); ++t) {
      const auto is_open = [&](int corner) { return coarse.unsewn[coarse.triangles[t][corner]]; };
      for (int i = 0; i < 3; ++i) {
        fine.unsewn[fine.triangles[4 * t + i][i]] = is_open(i);
        // Half of an edge that is sewn at one end is open.
        fine.unsewn[fine.triangles[4 * t + 3][i]] =
            static_cast<char>(is_open(i) != 0 || is_open((i + 1) % 3) != 0);
      }
    }
  }
}

std::vector<Vec3> refine_positions(const PanelMesh& coarse, const std::vector<int>& coarse_nodes,
                                   const std::vector<Vec3>& coarse_positions, const PanelMesh& fine,
                                   const std::vector<int>& fine_nodes, int fine_node_count) {
  std::vector<Vec3> positions(fine_node_count, Vec3::Zero());
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t) {
    Vec3 corner[3];
    for (int i = 0; i < 3; ++i) {
      corner[i] = coarse_positions[coarse_nodes[coarse.triangles[t][i]]];
    }
    for (int i = 0; i < 3; ++i) {
      positions[fine_nodes[fine.triangles[4 * t + i][i]]] = corner[i];
    }
    // Child 3 is (m01, m12, m20).
    for (int i = 0; i < 3; ++i) {
      positions[fine_nodes[fine.triangles[4 * t + 3][i]]] = 0.5 * (corner[i] + corner[(i + 1) % 3]);
    }
  }
  return positions;
}

std::vector<Vec3> refine_points(const PanelMesh& coarse, const std::vector<Vec3>& of_points,
                                const PanelMesh& fine) {
  const auto each_its_own = [](const PanelMesh& garment) {
    std::vector<int> nodes(garment.flat.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  };
  return refine_positions(coarse, each_its_own(coarse), of_points, fine, each_its_own(fine),
                          static_cast<int>(fine.flat.size()));
}

std::vector<Vec3> refine_placed(const PanelMesh& coarse, std::vector<Vec3> placed,
                                const PanelMesh& fine) {
  for (std::size_t p = 0; p < placed.size(); ++p) placed[p] -= coarse.placed[p];
  std::vector<Vec3> finer = refine_points(coarse, placed, fine);
  for (std::size_t p = 0; p < finer.size(); ++p) finer[p] += fine.placed[p];
  return finer;
}

}  // namespace toile
