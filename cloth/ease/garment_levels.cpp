#include "cloth/ease/garment_levels.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/body/limbs_through.h"
#include "geometry/body/torso_section.h"
#include "geometry/border_loops.h"
#include "pattern/classify/classify.h"

namespace toile {

namespace {

using Edge = std::pair<int, int>;  // of nodes, the lower one first

bool is_bottom(const std::string& panel) {
  const PanelRole worn_as = classify({panel}).worn_as;
  return worn_as == PanelRole::skirt || worn_as == PanelRole::trousers ||
         worn_as == PanelRole::waistband;
}

/// The border loops of some triangles through which both legs pass, the highest first.
std::vector<std::vector<int>> loops_around_trunk(const DressedGarment& garment,
                                                 const std::vector<Triangle>& triangles,
                                                 const Skeleton& skeleton) {
  std::vector<std::pair<double, std::vector<int>>> by_height;
  for (std::vector<int>& loop : border_loops(triangles, garment.points.size())) {
    std::vector<Vec3> curve;
    curve.reserve(loop.size());
    double height = 0;
    for (const int node : loop) {
      curve.push_back(garment.points[node]);
      height += garment.points[node].y() / static_cast<double>(loop.size());
    }
    if (limbs_through(curve, skeleton) == through_hem) by_height.emplace_back(height, loop);
  }
  std::ranges::stable_sort(by_height, std::ranges::greater{},
                           &std::pair<double, std::vector<int>>::first);
  std::vector<std::vector<int>> loops;
  loops.reserve(by_height.size());
  for (auto& [height, loop] : by_height) loops.push_back(std::move(loop));
  return loops;
}

/// Metres, per edge: its length on the flat, the least of the triangles beside it.
std::map<Edge, double> flat_lengths(const DressedGarment& garment) {
  std::map<Edge, double> lengths;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Triangle& flat = garment.flat_triangles[t];
      const double length = (garment.flat[flat[i]] - garment.flat[flat[j]]).norm();
      const Edge edge = std::minmax(garment.triangles[t][i], garment.triangles[t][j]);
      const auto [at, is_new] = lengths.emplace(edge, length);
      if (!is_new) at->second = std::min(at->second, length);
    }
  }
  return lengths;
}

}  // namespace

std::vector<GarmentLevel> measure_garment_levels(const DressedGarment& garment,
                                                 const TriangleMesh& body,
                                                 const Skeleton& skeleton) {
  std::vector<GarmentLevel> levels;
  if (!has_all_limbs(skeleton)) return levels;
  const std::map<Edge, double> lengths = flat_lengths(garment);
  const auto add = [&](const std::string& name, const std::vector<int>& loop) {
    GarmentLevel level;
    level.name = name;
    level.nodes = loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int from = loop[i];
      const int to = loop[(i + 1) % loop.size()];
      level.height += garment.points[from].y() / static_cast<double>(loop.size());
      level.garment += (garment.points[to] - garment.points[from]).norm();
      const auto length = lengths.find(std::minmax(from, to));
      if (length != lengths.end()) level.as_cut += length->second;
    }
    const double low = skeleton.joint("pelvis").y();
    const double high = skeleton.joint("chest").y();
    if (level.height > low && level.height < high) {
      if (const auto torso = torso_section(body, level.height)) level.body = torso->girth;
    }
    levels.push_back(std::move(level));
  };

  const auto edges = loops_around_trunk(garment, garment.triangles, skeleton);
  if (edges.size() > 1) add("top edge", edges.front());
  std::vector<Triangle> bottom;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (is_bottom(garment.panels[garment.panel_of_triangle[t]])) {
      bottom.push_back(garment.triangles[t]);
    }
  }
  if (bottom.size() < garment.triangles.size()) {
    const auto seams = loops_around_trunk(garment, bottom, skeleton);
    const auto is_edge = [&](const std::vector<int>& loop) {
      return std::ranges::any_of(edges, [&](const std::vector<int>& edge) {
        return std::ranges::find(edge, loop.front()) != edge.end();
      });
    };
    if (!seams.empty() && !is_edge(seams.front())) add("waist seam", seams.front());
  }
  if (edges.size() == 1) {
    double edge = 0;
    for (const int node : edges[0]) edge += garment.points[node].y() / edges[0].size();
    double cloth = 0;
    for (const Vec3& p : garment.points)
      cloth += p.y() / static_cast<double>(garment.points.size());
    add(edge > cloth ? "top edge" : "hem", edges[0]);
  } else if (!edges.empty()) {
    add("hem", edges.back());
  }
  std::ranges::stable_sort(levels, std::ranges::greater{}, &GarmentLevel::height);
  return levels;
}

}  // namespace toile
