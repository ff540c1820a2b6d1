#include "cloth/ease/garment_levels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "cloth/ease/cloth_line.h"
#include "cloth/ease/figure_errors.h"
#include "geometry/body/limbs_through.h"
#include "geometry/body/torso_section.h"
#include "geometry/border_loops.h"
#include "geometry/slice.h"
#include "pattern/classify/classify.h"

namespace toile {

namespace {

struct Loop {
  std::vector<int> nodes;
  LimbsThrough limbs;
  Vec3 middle = Vec3::Zero();
};

/// The border loops of some triangles, the highest first.
std::vector<Loop> loops_of(const DressedGarment& garment, const std::vector<Triangle>& triangles,
                           const Skeleton& skeleton) {
  std::vector<Loop> loops;
  for (std::vector<int>& nodes : border_loops(triangles, garment.points.size())) {
    Loop loop;
    std::vector<Vec3> curve;
    curve.reserve(nodes.size());
    for (const int node : nodes) {
      curve.push_back(garment.points[node]);
      loop.middle += garment.points[node] / static_cast<double>(nodes.size());
    }
    loop.limbs = limbs_through(curve, skeleton);
    loop.nodes = std::move(nodes);
    loops.push_back(std::move(loop));
  }
  std::ranges::stable_sort(loops, std::ranges::greater{},
                           [](const Loop& loop) { return loop.middle.y(); });
  return loops;
}

std::vector<Loop> around_trunk(std::vector<Loop> loops) {
  std::erase_if(loops, [](const Loop& loop) { return loop.limbs != through_hem; });
  return loops;
}

/// Share of the upper arm from the shoulder down to which an edge is an armhole's. Half and double
/// were not tried.
constexpr double armhole_share = 0.25;

/// "left cuff", "left armhole" or "left leg hem"; empty: not one limb alone passes through.
std::string limb_edge(const Loop& loop, const Skeleton& skeleton) {
  for (const std::string side : {"left", "right"}) {
    const bool is_left = side == "left";
    if (loop.limbs == LimbsThrough{is_left, !is_left, false, false}) {
      const Vec3& shoulder = skeleton.joint(side + "_shoulder");
      const Vec3 arm = skeleton.joint(side + "_elbow") - shoulder;
      const double share = (loop.middle - shoulder).dot(arm) / arm.squaredNorm();
      return side + (share < armhole_share ? " armhole" : " cuff");
    }
    if (loop.limbs == LimbsThrough{false, false, is_left, !is_left}) return side + " leg hem";
  }
  return "";
}

/// The girth of the body's part that passes through a loop, square to the loop.
std::optional<double> girth_through(const TriangleMesh& body, const DressedGarment& garment,
                                    const Loop& loop) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
    const Vec3 from = garment.points[loop.nodes[i]] - loop.middle;
    normal += from.cross(garment.points[loop.nodes[(i + 1) % loop.nodes.size()]] - loop.middle);
  }
  if (!(normal.norm() > 0)) return std::nullopt;
  std::optional<double> girth;
  for (const Section& section : slice(body, loop.middle, normal)) {
    if (section.area > 0 && contains(section, loop.middle, normal)) girth = section.girth;
  }
  return girth;
}

}  // namespace

bool hangs_from_waist(PanelRole worn_as) {
  return worn_as == PanelRole::skirt || worn_as == PanelRole::trousers ||
         worn_as == PanelRole::waistband;
}

std::optional<GarmentLevel::Compared> GarmentLevel::compared() const {
  const bool is_surer_at_rest = name == "top edge" && body && body < drafted_body;
  if (drafted_body && !is_surer_at_rest) return Compared{*drafted_body, drafted_body_error, true};
  if (!body) return std::nullopt;
  return Compared{*body, edge_as_cut_error, false};
}

std::vector<PanelRole> worn_as(const PanelMesh& pattern) {
  std::vector<PanelRole> roles;
  roles.reserve(pattern.panels.size());
  for (const MeshedPanel& panel : pattern.panels) roles.push_back(panel.is.worn_as);
  return roles;
}

std::vector<PanelRole> worn_as(const std::vector<std::string>& panels) {
  std::vector<PanelRole> roles;
  roles.reserve(panels.size());
  for (const std::string& panel : panels) roles.push_back(classify({panel}).worn_as);
  return roles;
}

std::vector<GarmentLevel> measure_garment_levels(const DressedGarment& garment,
                                                 const TriangleMesh& body, const Skeleton& skeleton,
                                                 const std::vector<PanelRole>& worn_as,
                                                 const BodyMeasures& measures) {
  std::vector<GarmentLevel> levels;
  if (!has_all_limbs(skeleton)) return levels;
  const std::map<std::pair<int, int>, FlatEdge> flat = flat_edges(garment);
  const auto measure = [&](const std::string& name, const Loop& loop) {
    GarmentLevel level;
    level.name = name;
    level.nodes = loop.nodes;
    level.height = loop.middle.y();
    std::set<int> panels;
    for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
      const int from = loop.nodes[i];
      const int to = loop.nodes[(i + 1) % loop.nodes.size()];
      level.garment += (garment.points[to] - garment.points[from]).norm();
      const auto edge = flat.find(std::minmax(from, to));
      if (edge == flat.end()) continue;
      level.as_cut += edge->second.length;
      panels.insert(edge->second.panels.begin(), edge->second.panels.end());
    }
    level.panels.assign(panels.begin(), panels.end());
    return level;
  };
  const auto add = [&](const std::string& name, const Loop& loop) {
    GarmentLevel level = measure(name, loop);
    const double low = skeleton.joint("pelvis").y();
    const double high = skeleton.joint("chest").y();
    if (level.height > low && level.height < high) {
      if (const auto torso = torso_section(body, level.height)) level.body = torso->girth;
    }
    levels.push_back(std::move(level));
  };

  const std::vector<Loop> borders = loops_of(garment, garment.triangles, skeleton);
  const std::vector<Loop> edges = around_trunk(borders);
  if (edges.size() > 1) add("top edge", edges.front());
  std::vector<Triangle> bottom;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (hangs_from_waist(worn_as[garment.panel_of_triangle[t]]))
      bottom.push_back(garment.triangles[t]);
  }
  if (bottom.size() < garment.triangles.size()) {
    const std::vector<Loop> seams = around_trunk(loops_of(garment, bottom, skeleton));
    const auto is_edge = [&](const Loop& loop) {
      return std::ranges::any_of(edges, [&](const Loop& edge) {
        return std::ranges::find(edge.nodes, loop.nodes.front()) != edge.nodes.end();
      });
    };
    if (!seams.empty() && !is_edge(seams.front())) add("waist seam", seams.front());
  }
  if (edges.size() == 1) {
    double cloth = 0;
    for (const Vec3& p : garment.points)
      cloth += p.y() / static_cast<double>(garment.points.size());
    add(edges[0].middle.y() > cloth ? "top edge" : "hem", edges[0]);
  } else if (!edges.empty()) {
    add("hem", edges.back());
  }
  std::ranges::stable_sort(levels, std::ranges::greater{}, &GarmentLevel::height);
  for (const Loop& loop : borders) {
    const bool is_neckline = loop.limbs == through_neckline;
    const std::string name = is_neckline ? "neckline" : limb_edge(loop, skeleton);
    if (name.empty()) continue;
    GarmentLevel level = measure(name, loop);
    level.is_of_limb = true;
    if (is_neckline) {
      const auto base = measures.lengths.find("neck_base");
      if (base != measures.lengths.end()) level.body = base->second;
    } else if (!name.ends_with("armhole")) {
      level.body = girth_through(body, garment, loop);
    }
    levels.push_back(std::move(level));
  }
  // Left beside right.
  const auto limbs = std::ranges::find_if(levels, &GarmentLevel::is_of_limb);
  std::ranges::stable_sort(limbs, levels.end(), {}, [](const GarmentLevel& level) {
    return std::pair(level.name.substr(level.name.find(' ') + 1), level.name);
  });
  return levels;
}

}  // namespace toile
