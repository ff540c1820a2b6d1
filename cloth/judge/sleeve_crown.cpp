#include "cloth/judge/sleeve_crown.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cloth/judge/constants.h"

namespace toile {

namespace {

/// Of a panel, its nodes and where they are on the flat panel.
using FlatNodes = std::map<int, Vec2>;

FlatNodes flat_nodes(const PanelMesh& garment, const DressedGarment& dressed, int panel) {
  FlatNodes flat;
  const MeshedPanel& meshed = garment.panels[panel];
  for (int t = meshed.first_triangle; t < meshed.first_triangle + meshed.triangles; ++t) {
    for (int i = 0; i < 3; ++i) {
      flat.emplace(dressed.triangles[t][i], garment.flat[garment.triangles[t][i]]);
    }
  }
  return flat;
}

/// Per panel of a sleeve, its edge towards the hand: at the sleeve's opening, or at a cuff.
std::map<int, std::vector<Vec2>> cuff_edges(const std::map<int, FlatNodes>& sleeve,
                                            const std::vector<const Opening*>& openings,
                                            const LimbsThrough& arm) {
  std::set<int> ends;  // nodes
  for (const Opening* opening : openings) {
    if (opening->limbs == arm) ends.insert(opening->nodes.begin(), opening->nodes.end());
  }
  std::map<int, std::vector<Vec2>> edges;
  const auto add_edges = [&] {
    std::vector<int> added;
    for (const auto& [p, flat] : sleeve) {
      std::vector<Vec2> edge;
      for (const auto& [node, place] : flat) {
        if (ends.contains(node)) edge.push_back(place);
      }
      if (edge.size() > 2 && edges.emplace(p, edge).second) added.push_back(p);
    }
    return added;
  };
  for (const int p : add_edges()) {
    for (const auto& [node, place] : sleeve.at(p)) ends.insert(node);
  }
  add_edges();
  return edges;
}

}  // namespace

bool is_set_in_upside_down(const PanelMesh& garment, const DressedGarment& dressed,
                           const std::vector<int>& sleeve, const std::vector<int>& trunk,
                           const std::vector<const Opening*>& openings, const LimbsThrough& arm) {
  std::set<int> of_trunk;
  for (const int p : trunk) {
    for (const auto& [node, place] : flat_nodes(garment, dressed, p)) of_trunk.insert(node);
  }
  std::map<int, FlatNodes> flat;
  for (const int p : sleeve) flat.emplace(p, flat_nodes(garment, dressed, p));
  double widest = 0;
  double together = 0;  // sums about the middle of each panel's part of the seam
  double of_reach = 0;
  double of_height = 0;
  for (const auto& [p, edge] : cuff_edges(flat, openings, arm)) {
    Vec2 middle = Vec2::Zero();
    for (const Vec2& place : edge) middle += place / static_cast<double>(edge.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vec2& place : edge) spread += (place - middle) * (place - middle).transpose();
    const Vec2 across =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(0);
    std::vector<Vec2> seam;  // metres from the cuff's line, metres above the floor
    Vec2 mean = Vec2::Zero();
    for (const auto& [node, place] : flat.at(p)) {
      if (!of_trunk.contains(node)) continue;
      seam.emplace_back(std::abs(across.dot(place - middle)), dressed.points[node].y());
      mean += seam.back();
    }
    if (seam.empty()) continue;
    mean /= static_cast<double>(seam.size());
    const auto [nearest, farthest] =
        std::ranges::minmax_element(seam, {}, [](const Vec2& at) { return at.x(); });
    widest = std::max(widest, farthest->x() - nearest->x());
    for (const Vec2& at : seam) {
      const Vec2 off = at - mean;
      together += off.x() * off.y();
      of_reach += off.x() * off.x();
      of_height += off.y() * off.y();
    }
  }
  if (widest < min_crown_height || of_height == 0) return false;
  return together / std::sqrt(of_reach * of_height) < upside_down_correlation;
}

}  // namespace toile
