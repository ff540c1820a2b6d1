#include "cloth/judge/openings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "cloth/judge/constants.h"
#include "cloth/judge/drafted.h"
#include "geometry/body/torso_section.h"
#include "geometry/border_loops.h"
#include "geometry/disjoint_sets.h"

namespace toile {

std::vector<int> connected_components(const DressedGarment& dressed) {
  DisjointSets sets(dressed.points.size());
  std::vector<char> is_used(dressed.points.size(), 0);
  for (const Triangle& t : dressed.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
    for (const int p : t) is_used[p] = 1;
  }
  std::vector<int> component(dressed.points.size(), -1);
  std::map<int, int> number;
  for (std::size_t p = 0; p < component.size(); ++p) {
    if (!is_used[p]) continue;
    component[p] =
        number.emplace(sets.of(static_cast<int>(p)), static_cast<int>(number.size())).first->second;
  }
  return component;
}

namespace {

/// Whether a head is meant to pass through the opening, and nothing does.
bool lacks_head(const Opening& opening) {
  return !opening.limbs.any() && opening.length >= min_neck_opening;
}

std::vector<Vec3> curve_of(const Opening& opening, const DressedGarment& dressed) {
  std::vector<Vec3> curve;
  curve.reserve(opening.nodes.size());
  for (const int node : opening.nodes) curve.push_back(dressed.points[node]);
  return curve;
}

/// A hood may hang over the eyes. The face then looks out below the hood's edge, or beside a fold
/// of it. Where nothing passes through an opening of its size, other ways out of the head are
/// tried. One way out tells all openings of a garment.
void look_out_below_the_hood(const DressedGarment& dressed, const Skeleton& skeleton,
                             std::vector<Opening>& openings) {
  for (const double face : {0.4, 0.2, 0.8}) {
    if (std::ranges::none_of(openings, lacks_head)) return;
    std::vector<Opening> told = openings;
    for (Opening& opening : told) {
      opening.limbs = limbs_through(curve_of(opening, dressed), skeleton, face);
    }
    if (std::ranges::none_of(told, lacks_head)) openings = std::move(told);
  }
}

}  // namespace

std::vector<Opening> find_openings(const PanelMesh& garment, const DressedGarment& dressed,
                                   const Skeleton& skeleton) {
  const std::vector<int> component = connected_components(dressed);
  std::vector<Triangle> triangles;
  const std::set<int> cut = points_at_cut_outs(garment);
  std::set<int> cut_nodes;
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    if (garment.panels[dressed.panel_of_triangle[t]].layered) continue;
    triangles.push_back(dressed.triangles[t]);
    for (int i = 0; i < 3 && !cut.empty(); ++i) {
      if (cut.contains(dressed.flat_triangles[t][i])) cut_nodes.insert(dressed.triangles[t][i]);
    }
  }
  std::vector<std::vector<int>> loops = border_loops(triangles, dressed.points.size());
  // Of each border edge, its flat length and its panel.
  std::map<std::pair<int, int>, std::pair<double, int>> edges;
  for (const std::vector<int>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges[std::minmax(loop[i], loop[(i + 1) % loop.size()])] = {};
    }
  }
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    if (garment.panels[dressed.panel_of_triangle[t]].layered) continue;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const auto edge = edges.find(std::minmax(dressed.triangles[t][i], dressed.triangles[t][j]));
      if (edge == edges.end()) continue;
      const Triangle& flat = dressed.flat_triangles[t];
      edge->second = {(dressed.flat[flat[i]] - dressed.flat[flat[j]]).norm(),
                      dressed.panel_of_triangle[t]};
    }
  }
  const std::vector<double> starts = start_heights(garment, dressed);
  std::vector<Opening> openings;
  for (std::vector<int>& loop : loops) {
    Opening opening;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& [length, panel] = edges.at(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
      opening.length += length;
      opening.panels.push_back(panel);
      opening.middle += dressed.points[loop[i]] / static_cast<double>(loop.size());
    }
    opening.drafted = opening.middle.y() +
                      came_down_at_centre(loop, starts, dressed, skeleton.joint("pelvis").x());
    opening.is_cut_out =
        std::ranges::all_of(loop, [&](int node) { return cut_nodes.contains(node); });
    opening.component = component[loop.front()];
    opening.nodes = std::move(loop);
    opening.limbs = limbs_through(curve_of(opening, dressed), skeleton);
    openings.push_back(std::move(opening));
  }
  look_out_below_the_hood(dressed, skeleton, openings);
  return openings;
}

double largest_girth(const TriangleMesh& body, double low, double high) {
  double largest = 0;
  for (int i = 0; i <= trunk_stations; ++i) {
    const double height = low + (high - low) * i / trunk_stations;
    if (const auto torso = torso_section(body, height)) largest = std::max(largest, torso->girth);
  }
  return largest;
}

void measure_passing(std::vector<Opening>& openings, const TriangleMesh& body,
                     const Skeleton& skeleton) {
  const double crotch = skeleton.joint("pelvis").y();
  const double armpit = skeleton.joint("chest").y();
  for (Opening& opening : openings) {
    if (opening.limbs == through_neckline) {
      const auto head = head_section(body, skeleton.joint("neck").y(), skeleton.joint("head").y());
      if (head) opening.passes = head->girth;
    }
    if (opening.limbs != through_hem) continue;
    const auto [low, high] = std::minmax({opening.middle.y(), opening.drafted});
    if (high <= crotch || low >= armpit) continue;
    opening.passes = largest_girth(body, std::max(low, crotch), std::min(high, armpit));
  }
}

bool is_too_small(const Opening& opening, double length) {
  return length < shut_opening_share * opening.passes;
}

}  // namespace toile
