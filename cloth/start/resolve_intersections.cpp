#include "cloth/start/resolve_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cloth/scene/constants.h"
#include "cloth/start/constants.h"
#include "cloth/start/facing.h"
#include "cloth/start/panel_parts.h"
#include "geometry/body/bones.h"
#include "geometry/disjoint_sets.h"
#include "geometry/error.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// Calls `with` for each pair of points that are to be sewn and are in one place.
template <typename With>
void for_joined_points(const PanelMesh& garment, const std::vector<Vec3>& placed,
                       const With& with) {
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      if ((placed[seam.a[i]] - placed[seam.b[i]]).norm() < same_place) with(seam.a[i], seam.b[i]);
    }
  }
}

/// Panels that stand joined along a seam: they are moved as one.
struct JoinedPanels {
  std::vector<int> panels;
  std::vector<int> points;
  std::vector<Triangle> triangles;
  double distance = 0;  ///< metres, mean of its points from the collider
};

class IntersectionResolver {
 public:
  IntersectionResolver(const PanelMesh& garment, const TriangleMesh& collider,
                       const DistanceGrid& distance, const Skeleton* skeleton, Placement& placement)
      : garment_(garment),
        collider_(collider),
        distance_(distance),
        skeleton_(skeleton),
        placement_(placement) {}

  void run() {
    find_units();
    std::vector<char> settled(garment_.panels.size(), 0);
    std::string stuck;
    for (const JoinedPanels& unit : units_) {
      if (!place(unit, settled)) {
        for (const int p : unit.panels) stuck += (stuck.empty() ? "'" : ", '") + name(p) + "'";
      }
      for (const int p : unit.panels) settled[p] = 1;
    }
    if (!stuck.empty()) {
      throw Error("panels " + stuck,
                  "start inside the body or through other panels, and find no place clear of them",
                  "place each before its own side of the body");
    }
    placement_.points_inside = points_inside(placement_.placed, distance_);
  }

  /// Whether any panel meets the collider or another one.
  bool is_due() const {
    return meets_collider(garment_.triangles, placement_.placed) ||
           !crossing_panels(garment_, placement_.placed).empty();
  }

 private:
  const std::string& name(int p) const { return garment_.panels[p].name; }

  /// Finds the units, the nearest to the collider first.
  void find_units() {
    const std::vector<int> panel_of = panel_of_points(garment_);
    DisjointSets sets(garment_.panels.size());
    for_joined_points(garment_, placement_.placed,
                      [&](int a, int b) { sets.join(panel_of[a], panel_of[b]); });
    // Panels that cross one another cannot be cleared as one.
    std::vector<char> alone(garment_.panels.size(), 0);
    for (const auto& [a, b] : crossing_panels(garment_, placement_.placed)) {
      if (sets.of(a) == sets.of(b)) alone[sets.of(a)] = 1;
    }
    std::map<int, JoinedPanels> units;
    for (std::size_t p = 0; p < garment_.panels.size(); ++p) {
      const MeshedPanel& panel = garment_.panels[p];
      const int joined = sets.of(static_cast<int>(p));
      JoinedPanels& unit = units[alone[joined] ? static_cast<int>(p) : joined];
      unit.panels.push_back(static_cast<int>(p));
      for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
        unit.points.push_back(i);
        unit.distance += distance_.at(placement_.placed[i]).distance;
      }
      const auto first = garment_.triangles.begin() + panel.first_triangle;
      unit.triangles.insert(unit.triangles.end(), first, first + panel.triangles);
    }
    for (auto& [lowest, unit] : units) {
      unit.distance /= static_cast<double>(unit.points.size());
      units_.push_back(std::move(unit));
    }
    // Units at the same distance, whatever rounding says, stay in their order.
    std::stable_sort(
        units_.begin(), units_.end(), [](const JoinedPanels& a, const JoinedPanels& b) {
          return std::lround(a.distance / same_distance) < std::lround(b.distance / same_distance);
        });
  }

  /// Per point of a unit, the unit vector along which it is to be moved. `flat` becomes whether all
  /// points have the same.
  std::vector<Vec3> directions(const JoinedPanels& unit, bool& flat) const {
    const std::vector<Vec3>& at = placement_.placed;
    const FacingSum sum = facing_of(unit.triangles, at);
    flat = sum.flatter_than(planar_flatness) || skeleton_ == nullptr;
    std::vector<Vec3> result(unit.points.size());
    if (flat) {
      Vec3 direction = sum.vectors.norm() > 0 ? Vec3(sum.vectors.normalized()) : Vec3::UnitZ();
      // The right side faces away from the body, unless it surely stands on the wrong one.
      double out = 0;
      for (const int p : unit.points) {
        out += distance_.at(at[p] + outward_probe * direction).distance -
               distance_.at(at[p] - outward_probe * direction).distance;
      }
      if (out < -wrong_side_share * outward_probe * static_cast<double>(unit.points.size()))
        direction = -direction;
      std::fill(result.begin(), result.end(), direction);
      return result;
    }
    const Bones bones(*skeleton_, panel_parts(garment_, *skeleton_)[unit.panels.front()]);
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Vec3& p = at[unit.points[i]];
      const Vec3 away = p - bones.at(bones.foot(p)).first;
      result[i] = away.norm() > 0 ? Vec3(away.normalized()) : Vec3::Zero();
    }
    return result;
  }

  /// Metres, per material point: all panels' points with the unit moved `steps` along `out`.
  std::vector<Vec3> moved(const JoinedPanels& unit, const std::vector<Vec3>& out, int steps) const {
    std::vector<Vec3> points = placement_.placed;
    for (std::size_t i = 0; i < out.size(); ++i)
      points[unit.points[i]] += steps * clearing_step * out[i];
    return points;
  }

  /// Whether any of the triangles meets the collider or is inside of it.
  bool meets_collider(const std::vector<Triangle>& triangles,
                      const std::vector<Vec3>& points) const {
    TriangleMesh near{points, {}};
    for (const Triangle& corners : triangles) {
      double longest = 0;
      double nearest = 1e300;
      for (int i = 0; i < 3; ++i) {
        const Vec3& p = points[corners[i]];
        const double at = distance_.at(p).distance;
        if (at < surely_inside) return true;
        nearest = std::min(nearest, distance_.lower_bound(at));
        longest = std::max(longest, (p - points[corners[(i + 1) % 3]]).norm());
      }
      if (nearest < longest) near.triangles.push_back(corners);
    }
    return !near.triangles.empty() && !intersections(near, collider_).empty();
  }

  bool is_clear(const JoinedPanels& unit, const std::vector<char>& settled,
                const std::vector<Vec3>& points) const {
    if (meets_collider(unit.triangles, points)) return false;
    std::vector<char> mine(garment_.panels.size(), 0);
    for (const int p : unit.panels) mine[p] = 1;
    const std::vector<std::pair<int, int>> crossing = crossing_panels(garment_, points);
    return std::none_of(crossing.begin(), crossing.end(), [&](const std::pair<int, int>& pair) {
      const auto [a, b] = pair;
      return (mine[a] && (settled[b] || mine[b])) || (mine[b] && settled[a]);
    });
  }

  bool place(const JoinedPanels& unit, const std::vector<char>& settled) {
    if (is_clear(unit, settled, placement_.placed)) return true;
    bool flat = true;
    const std::vector<Vec3> out = directions(unit, flat);
    const int max_steps = flat ? max_flat_clearing_steps : max_bent_clearing_steps;
    for (int steps = 1; steps <= max_steps; ++steps) {
      std::vector<Vec3> points = moved(unit, out, steps);
      if (!is_clear(unit, settled, points)) continue;
      int best = steps;
      // A unit that is only just clear has no room to move. So one more step is tried.
      std::vector<Vec3> farther = moved(unit, out, steps + 1);
      if (is_clear(unit, settled, farther)) {
        points = std::move(farther);
        ++best;
      }
      placement_.placed = std::move(points);
      for (const int p : unit.panels) placement_.moved_clear[name(p)] += best * clearing_step;
      return true;
    }
    return false;
  }

  const PanelMesh& garment_;
  const TriangleMesh& collider_;
  const DistanceGrid& distance_;
  const Skeleton* skeleton_;
  Placement& placement_;
  std::vector<JoinedPanels> units_;
};

/// The garment's triangles, sewn points that are in one place made one.
std::vector<Triangle> joined(const PanelMesh& garment, const std::vector<Vec3>& placed) {
  DisjointSets sets(placed.size());
  for_joined_points(garment, placed, [&](int a, int b) { sets.join(a, b); });
  return sets.joined(garment.triangles);
}

}  // namespace

std::vector<std::pair<int, int>> crossing_panels(const PanelMesh& garment,
                                                 const std::vector<Vec3>& placed) {
  const std::vector<int> panel_of = panel_of_triangles(garment);
  std::set<std::pair<int, int>> pairs;
  for (const auto& [s, t] : self_intersections({placed, joined(garment, placed)})) {
    if (panel_of[s] != panel_of[t]) pairs.insert(std::minmax(panel_of[s], panel_of[t]));
  }
  return {pairs.begin(), pairs.end()};
}

void resolve_intersections(const PanelMesh& garment, const TriangleMesh& collider,
                           const DistanceGrid& distance, const Skeleton* skeleton,
                           Placement& placement) {
  IntersectionResolver resolver(garment, collider, distance, skeleton, placement);
  if (resolver.is_due()) resolver.run();
}

}  // namespace toile
