#include "cloth/ease/lengths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "geometry/body/limbs_through.h"
#include "pattern/classify/classify.h"

namespace toile {

namespace {

/// Metres from a limb's line within which cloth is of that limb. Half and double were not tried.
constexpr double beside_limb = 0.2;

/// An edge of the mesh along a seam.
struct SeamEdge {
  int from = 0;  ///< node
  int to = 0;
  FlatEdge flat;
};

class LengthTaker {
 public:
  LengthTaker(const DressedGarment& garment, const Skeleton& skeleton, const BodyMeasures& measures,
              const std::vector<PanelRole>& worn_as, const std::vector<GarmentLevel>& levels)
      : garment_(garment),
        skeleton_(skeleton),
        measures_(measures),
        worn_as_(worn_as),
        levels_(levels),
        middle_(skeleton.joint("neck").x()),
        panels_of_node_(garment.points.size()) {
    for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
      for (const int node : garment.triangles[t]) {
        panels_of_node_[node].insert(garment.panel_of_triangle[t]);
      }
    }
  }

  std::vector<GarmentLength> taken() {
    for (const std::string side : {"left", "right"}) take_sleeve(side);
    take_middle();
    for (const std::string side : {"left", "right"}) take_leg(side);
    return std::move(lengths_);
  }

 private:
  PanelRole role(const PathStep& step) const { return worn_as_[step.panel]; }
  std::optional<double> body(const std::string& measure) const {
    const auto found = measures_.lengths.find(measure);
    if (found == measures_.lengths.end()) return std::nullopt;
    return found->second;
  }
  void add(GarmentLength length) {
    // A slit parts a path: the first part counts.
    const auto taken = std::ranges::find(lengths_, length.name, &GarmentLength::name);
    if (length.worn > 0 && taken == lengths_.end()) lengths_.push_back(std::move(length));
  }
  void add(const std::string& name, const ClothPath& path, std::optional<double> body,
           std::vector<EndsBeyond> ends) {
    add({name, flat_length(path), worn_length(path), body, std::move(ends)});
  }

  /// The paths of a plane, each from both of its ends.
  std::vector<ClothPath> both_ways(const CuttingPlane& plane) const {
    std::vector<ClothPath> paths = paths_on_plane(garment_, plane);
    const std::size_t count = paths.size();
    for (std::size_t i = 0; i < count; ++i) paths.push_back(reversed(paths[i]));
    return paths;
  }

  void take_sleeve(const std::string& side) {
    const Vec3& shoulder = skeleton_.joint(side + "_shoulder");
    const Vec3& elbow = skeleton_.joint(side + "_elbow");
    const Vec3& wrist = skeleton_.joint(side + "_wrist");
    const Vec3 arm = (wrist - shoulder).normalized();
    // Over the arm: up from it, or outward from one that hangs straight down.
    Vec3 over = Vec3::UnitY() + Vec3(side == "left" ? 0.2 : -0.2, 0, 0);
    over = (over - over.dot(arm) * arm).normalized();
    const auto along = [&](const Vec3& p) { return (p - shoulder).dot(arm); };
    for (const ClothPath& path : both_ways({shoulder, arm.cross(over)})) {
      const Vec3& end = path.front().worn_from;
      const Vec3 off = end - shoulder - along(end) * arm;
      if (role(path.front()) != PanelRole::sleeve || along(end) <= 0 || off.dot(over) <= 0 ||
          off.norm() > beside_limb) {
        continue;
      }
      const auto armhole = std::ranges::find_if(
          path, [&](const PathStep& step) { return role(step) != PanelRole::sleeve; });
      add(side + " sleeve", {path.begin(), armhole}, body(side + "_arm_length"),
          {{side + " elbow", along(end) - along(elbow)},
           {side + " wrist", along(end) - along(wrist)}});
      // Up to the neck. A path to the other sleeve shows no end of the shoulder.
      const ClothPath rest(armhole, path.end());
      const auto other = std::ranges::find_if(
          rest, [&](const PathStep& step) { return role(step) == PanelRole::sleeve; });
      if (rest.empty() || other != rest.end()) return;
      const auto found = measures_.shoulder_points.find(side);
      std::vector<EndsBeyond> ends;
      if (found != measures_.shoulder_points.end()) {
        const Vec3& point = found->second;
        ends.push_back({side + " shoulder point",
                        (rest.front().worn_from - point).dot(Vec3(arm.x(), 0, arm.z())) /
                            Vec3(arm.x(), 0, arm.z()).norm()});
      }
      add(side + " shoulder", rest, body(side + "_shoulder_length"), std::move(ends));
      return;
    }
  }

  /// What the body's middle plane meets: a line of the front and one of the back.
  void take_middle() {
    take_crotch();
    std::vector<ClothPath> paths = paths_on_plane(garment_, {Vec3(middle_, 0, 0), Vec3::UnitX()});
    std::erase_if(paths, [](const ClothPath& path) { return path.empty(); });
    if (paths.size() != 2) return;
    const auto depth = [](const ClothPath& path) {
      return path.front().worn_from.z() + path.back().worn_to.z();
    };
    if (depth(paths[0]) < depth(paths[1])) std::swap(paths[0], paths[1]);
    for (ClothPath& path : paths) {
      if (path.front().worn_from.y() < path.back().worn_to.y()) path = reversed(path);
    }
    take_centre("centre front", paths[0], body("front_centre_length"));
    take_centre("centre back", paths[1], body("back_centre_length"));
    take_across_shoulder(paths[1]);
    take_neck_drops(paths[0], paths[1]);
  }

  void take_centre(const std::string& name, const ClothPath& path,
                   std::optional<double> body_to_waist) {
    const auto seam = std::ranges::find_if(
        path, [&](const PathStep& step) { return hangs_from_waist(role(step)); });
    if (seam != path.begin() && seam != path.end()) {
      add(name + " to waist seam", {path.begin(), seam}, body_to_waist, {});
    }
    const double hem = path.back().worn_to.y();
    std::vector<EndsBeyond> ends = {{"floor", hem}};
    if (hem < skeleton_.joint("pelvis").y()) {
      const double knees =
          (skeleton_.joint("left_knee").y() + skeleton_.joint("right_knee").y()) / 2;
      ends.push_back({"knee", knees - hem});
    }
    add(name, path, {}, std::move(ends));
  }

  /// Points of a centre line that lie on one panel, from the top down.
  struct CentreLine {
    std::vector<std::pair<Vec2, Vec3>> points;  ///< flat and worn
    Vec2 up() const { return (points.front().first - points.back().first).normalized(); }
  };

  /// The centre line on one of the panels at its top: their seam, or the path on the panel. A path
  /// along a seam changes sides at random.
  CentreLine centre_line(const ClothPath& centre, int panel) const {
    CentreLine line;
    std::set<int> beside = panels_at_top(centre);
    std::erase_if(beside, [&](int other) { return other == panel || !ends_at_shoulder(other); });
    for_corners(panel, [&](int node, const Vec2& flat) {
      const bool is_on_seam = std::ranges::any_of(
          beside, [&](int other) { return panels_of_node_[node].contains(other); });
      if (is_on_seam) line.points.emplace_back(flat, garment_.points[node]);
    });
    std::ranges::stable_sort(line.points, std::ranges::greater{},
                             [](const auto& point) { return point.second.y(); });
    if (!line.points.empty()) return line;
    for (const PathStep& step : centre) {
      if (step.panel != panel) continue;
      line.points.emplace_back(step.flat_from, step.worn_from);
      line.points.emplace_back(step.flat_to, step.worn_to);
    }
    return line;
  }

  /// The panels at the top of a centre line.
  const std::set<int>& panels_at_top(const ClothPath& centre) const {
    const auto nearest = std::ranges::min_element(garment_.points, {}, [&](const Vec3& p) {
      return (p - centre.front().worn_from).squaredNorm();
    });
    return panels_of_node_[nearest - garment_.points.begin()];
  }

  /// Whether its upper edge is that of shoulders and neck.
  bool ends_at_shoulder(int panel) const {
    // What it is worn with says bodice of all three.
    const PanelRole is = classify({garment_.panels[panel]}).role;
    return is != PanelRole::collar && is != PanelRole::hood && is != PanelRole::yoke;
  }

  /// Whether the node lies on the edge of an armhole or at the seam of a sleeve.
  bool is_at_armhole(int node) const {
    const auto is_sleeve = [&](int panel) { return worn_as_[panel] == PanelRole::sleeve; };
    if (std::ranges::any_of(panels_of_node_[node], is_sleeve)) return true;
    return std::ranges::any_of(levels_, [&](const GarmentLevel& level) {
      return level.name.ends_with(" armhole") &&
             std::ranges::find(level.nodes, node) != level.nodes.end();
    });
  }

  /// Calls with the node and the flat point of each corner of a panel's triangles.
  template <typename Use>
  void for_corners(int panel, const Use& use) const {
    for (std::size_t t = 0; t < garment_.triangles.size(); ++t) {
      if (garment_.panel_of_triangle[t] != panel) continue;
      for (int i = 0; i < 3; ++i) {
        use(garment_.triangles[t][i], garment_.flat[garment_.flat_triangles[t][i]]);
      }
    }
  }

  /// The tape of the body runs over the back of the neck.
  void take_across_shoulder(const ClothPath& centre_back) {
    GarmentLength across{"across shoulder", 0};
    for (const double side : {1.0, -1.0}) {
      bool is_found = false;
      Vec2 flat_half(0, 0);
      Vec3 half(0, 0, 0);
      for (const int panel : panels_at_top(centre_back)) {
        if (!ends_at_shoulder(panel)) continue;
        const CentreLine line = centre_line(centre_back, panel);
        Vec2 flat_tip(0, 0);
        Vec3 tip(0, 0, 0);
        bool has_tip = false;
        for_corners(panel, [&](int node, const Vec2& flat) {
          if (side * (garment_.points[node].x() - middle_) <= 0 || !is_at_armhole(node)) return;
          if (has_tip && (flat - flat_tip).dot(line.up()) <= 0) return;
          has_tip = true;
          flat_tip = flat;
          tip = garment_.points[node];
        });
        if (!has_tip) continue;
        // The centre's point that is level with it, or the centre's top.
        const auto& [flat_centre, centre] = *std::ranges::min_element(
            line.points, {},
            [&](const auto& point) { return std::abs((point.first - flat_tip).dot(line.up())); });
        is_found = true;
        flat_half = flat_tip - flat_centre;
        half = tip - centre;
      }
      if (!is_found) return;
      *across.as_cut += flat_half.norm();
      across.worn += half.norm();
    }
    const std::optional<double> left = body("left_back_across_shoulder");
    const std::optional<double> right = body("right_back_across_shoulder");
    if (left && right) across.body = *left + *right;
    add(std::move(across));
  }

  void take_neck_drops(const ClothPath& front, const ClothPath& back) {
    const auto neckline = std::ranges::find(levels_, "neckline", &GarmentLevel::name);
    if (neckline == levels_.end()) return;
    const std::set<int>& fronts = panels_at_top(front);
    const std::set<int>& backs = panels_at_top(back);
    const auto is_of = [&](int node, const std::set<int>& panels) {
      return std::ranges::any_of(panels_of_node_[node], [&](int panel) {
        return ends_at_shoulder(panel) && panels.contains(panel);
      });
    };
    std::vector<int> sides;
    std::ranges::copy_if(neckline->nodes, std::back_inserter(sides),
                         [&](int node) { return is_of(node, fronts) && is_of(node, backs); });
    if (sides.empty()) return;
    take_neck_drop("front neck drop", front, sides);
    take_neck_drop("back neck drop", back, sides);
  }

  /// `sides` are nodes at the sides of the neck.
  void take_neck_drop(const std::string& name, const ClothPath& centre,
                      const std::vector<int>& sides) {
    GarmentLength drop{name};
    for (const int node : sides) {
      drop.worn += (garment_.points[node].y() - centre.front().worn_from.y()) /
                   static_cast<double>(sides.size());
    }
    const int panel = centre.front().panel;
    const Vec2 up = centre_line(centre, panel).up();
    for_corners(panel, [&](int node, const Vec2& flat) {
      if (std::ranges::find(sides, node) == sides.end()) return;
      drop.as_cut = (flat - centre.front().flat_from).dot(up);
    });
    lengths_.push_back(std::move(drop));
  }

  /// The seam between the panels of left and right legs, from the front's waist to the back's, as
  /// its edges in order. Empty: it is not one line, or there is none.
  std::vector<SeamEdge> crotch_seam() const {
    std::vector<double> across(worn_as_.size());
    for (std::size_t t = 0; t < garment_.triangles.size(); ++t) {
      for (const int node : garment_.triangles[t]) {
        across[garment_.panel_of_triangle[t]] += garment_.points[node].x() - middle_;
      }
    }
    std::map<int, std::vector<SeamEdge>> at;
    for (const auto& [nodes, edge] : flat_edges(garment_)) {
      if (edge.panels.size() != 2) continue;
      const int a = *edge.panels.begin();
      const int b = *edge.panels.rbegin();
      if (worn_as_[a] != PanelRole::trousers || worn_as_[b] != PanelRole::trousers ||
          across[a] * across[b] >= 0) {
        continue;
      }
      at[nodes.first].push_back({nodes.first, nodes.second, edge});
      at[nodes.second].push_back({nodes.second, nodes.first, edge});
    }
    std::vector<int> ends;
    for (const auto& [node, edges] : at) {
      if (edges.size() > 2) return {};
      if (edges.size() == 1) ends.push_back(node);
    }
    if (ends.size() != 2) return {};
    const auto depth = [&](int node) { return garment_.points[node].z(); };
    std::vector<SeamEdge> seam = {at[depth(ends[0]) > depth(ends[1]) ? ends[0] : ends[1]].front()};
    while (at[seam.back().to].size() == 2) {
      const std::vector<SeamEdge>& next = at[seam.back().to];
      seam.push_back(next[0].to == seam.back().from ? next[1] : next[0]);
    }
    return seam;
  }

  /// The waistband over the crotch seam's end, along the middle plane. `other` is its other end.
  ClothPath waistband_over(int node, int other) const {
    const auto is_band = [&](const PathStep& step) { return role(step) == PanelRole::waistband; };
    for (const ClothPath& path : both_ways({Vec3(middle_, 0, 0), Vec3::UnitX()})) {
      const auto end = std::ranges::find_if_not(path, is_band);
      if (end == path.begin() || end == path.end()) continue;
      const auto off = [&](int n) { return (garment_.points[n] - end->worn_from).norm(); };
      if (off(node) < off(other)) return {path.begin(), end};
    }
    return {};
  }

  void take_crotch() {
    const std::vector<SeamEdge> seam = crotch_seam();
    if (seam.empty()) return;
    const int ends[] = {seam.front().from, seam.back().to};
    const auto rise = [&](const std::string& name, auto from, auto to, bool is_front) {
      const ClothPath band = waistband_over(ends[is_front ? 0 : 1], ends[is_front ? 1 : 0]);
      GarmentLength length{name, flat_length(band), worn_length(band)};
      for (auto edge = from; edge != to; ++edge) {
        *length.as_cut += edge->flat.length;
        length.worn += (garment_.points[edge->to] - garment_.points[edge->from]).norm();
      }
      return length;
    };
    const auto crotch = seam.begin() + crotch_of(seam);
    const GarmentLength front = rise("front rise", seam.begin(), crotch, true);
    const GarmentLength back = rise("back rise", crotch, seam.end(), false);
    add({"crotch length", *front.as_cut + *back.as_cut, front.worn + back.worn,
         body("crotch_length")});
    add(front);
    add(back);
  }

  /// The edge with which the back begins: where all panels of the front end. Farther from the
  /// seam's lowest point than from its ends that is a yoke's seam. Then the lowest point parts it.
  std::ptrdiff_t crotch_of(const std::vector<SeamEdge>& seam) const {
    const auto lowest = std::ranges::min_element(
        seam, {}, [&](const SeamEdge& edge) { return garment_.points[edge.to].y(); });
    const std::ptrdiff_t at = lowest - seam.begin() + 1;
    const auto end = static_cast<std::ptrdiff_t>(seam.size());
    std::ptrdiff_t crotch = at;
    std::ptrdiff_t nearest = std::min(at, end - at) / 2;
    for (std::ptrdiff_t i = 1; i < end; ++i) {
      const std::set<int>& after = seam[i].flat.panels;
      const bool is_other = std::ranges::none_of(seam[i - 1].flat.panels,
                                                 [&](int panel) { return after.contains(panel); });
      if (!is_other || std::abs(i - at) >= nearest) continue;
      nearest = std::abs(i - at);
      crotch = i;
    }
    return crotch;
  }

  void take_leg(const std::string& side) {
    const Vec3& hip = skeleton_.joint(side + "_hip");
    const Vec3& ankle = skeleton_.joint(side + "_ankle");
    const Vec3 leg = (ankle - hip).normalized();
    const double outward = side == "left" ? 1 : -1;
    for (const ClothPath& path : both_ways({hip, leg.cross(Vec3::UnitX()).normalized()})) {
      const Vec3& hem = path.front().worn_from;
      const Vec3 off = hem - hip - (hem - hip).dot(leg) * leg;
      const bool is_this_leg = outward * (hem.x() - skeleton_.joint("pelvis").x()) > 0;
      if (role(path.front()) != PanelRole::trousers || hem.y() > hip.y() || !is_this_leg ||
          off.norm() > beside_limb) {
        continue;
      }
      const std::vector<EndsBeyond> ends = {
          {"floor", hem.y()}, {side + " knee", skeleton_.joint(side + "_knee").y() - hem.y()}};
      if (outward * off.x() > 0) {
        add(side + " outseam", path, {}, ends);
        continue;
      }
      const auto crotch =
          std::ranges::max_element(path, {}, [](const PathStep& step) { return step.worn_to.y(); });
      add(side + " inseam", {path.begin(), std::next(crotch)}, body("inside_leg"), ends);
    }
  }

  const DressedGarment& garment_;
  const Skeleton& skeleton_;
  const BodyMeasures& measures_;
  const std::vector<PanelRole>& worn_as_;
  const std::vector<GarmentLevel>& levels_;
  double middle_ = 0;  // x of the body's middle plane, metres
  std::vector<std::set<int>> panels_of_node_;
  std::vector<GarmentLength> lengths_;
};

}  // namespace

std::vector<GarmentLength> measure_lengths(const DressedGarment& garment, const Skeleton& skeleton,
                                           const BodyMeasures& measures,
                                           const std::vector<PanelRole>& worn_as,
                                           const std::vector<GarmentLevel>& levels) {
  if (!has_all_limbs(skeleton)) return {};
  return LengthTaker(garment, skeleton, measures, worn_as, levels).taken();
}

}  // namespace toile
