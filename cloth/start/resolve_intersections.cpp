#include "cloth/start/resolve_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cloth/start/panel_parts.h"
#include "geometry/body/bones.h"
#include "geometry/disjoint_sets.h"
#include "geometry/error.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

constexpr double step = 0.01;  // metres
constexpr int max_steps = 70;
constexpr double reach = 0.1;  // metres over which it is judged which way leads out
/// Metres: the distance grid rounds off corners, but not by that much.
constexpr double surely_inside = -0.002;
constexpr int max_widening = 15;  // steps
/// Metres: where a pattern places two sides in one place, only rounding lies between them.
constexpr double rounding = 1e-9;
/// A panel is flat when its areas, added as vectors, keep this share of their sum. A flat one has
/// 1. One rolled half around has 0.64, two that stand square to each other 0.71.
constexpr double flat_share = 0.68;

/// Calls `with` for each pair of points that are to be sewn and are in one place.
template <typename With>
void for_joined_points(const PanelMesh& garment, const std::vector<Vec3>& placed,
                       const With& with) {
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      if ((placed[seam.a[i]] - placed[seam.b[i]]).norm() < rounding) with(seam.a[i], seam.b[i]);
    }
  }
}

/// Panels that stand joined along a seam: they are moved as one.
struct Unit {
  std::vector<int> panels;
  std::vector<int> points;
  std::vector<Triangle> triangles;
  double distance = 0;  ///< metres, of its points from the collider, on average
};

class Clearing {
 public:
  Clearing(const PanelMesh& garment, const TriangleMesh& collider, const DistanceGrid& distance,
           const Skeleton* skeleton, Placement& placement)
      : garment_(garment),
        collider_(collider),
        distance_(distance),
        skeleton_(skeleton),
        placement_(placement) {}

  void run() {
    find_units();
    std::vector<char> settled(garment_.panels.size(), 0);
    std::string stuck;
    for (const Unit& unit : units_) {
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
    placement_.points_inside = 0;
    for (const Vec3& p : placement_.placed) {
      placement_.points_inside += distance_.at(p).distance < 0;
    }
  }

  /// Whether any panel meets the collider or another one.
  bool is_due() const {
    return meets_subject(garment_.triangles, placement_.placed) ||
           !crossing_panels(garment_, placement_.placed).empty();
  }

 private:
  const std::string& name(int p) const { return garment_.panels[p].name; }

  /// The nearest to the collider first.
  void find_units() {
    std::vector<int> panel_of;
    for (std::size_t p = 0; p < garment_.panels.size(); ++p) {
      panel_of.insert(panel_of.end(), garment_.panels[p].points, static_cast<int>(p));
    }
    DisjointSets sets(garment_.panels.size());
    for_joined_points(garment_, placement_.placed,
                      [&](int a, int b) { sets.join(panel_of[a], panel_of[b]); });
    // What crosses what it is joined to can't get clear of it with it.
    std::vector<char> alone(garment_.panels.size(), 0);
    for (const auto& [a, b] : crossing_panels(garment_, placement_.placed)) {
      if (sets.of(a) == sets.of(b)) alone[sets.of(a)] = 1;
    }
    std::map<int, Unit> units;
    for (std::size_t p = 0; p < garment_.panels.size(); ++p) {
      const MeshedPanel& panel = garment_.panels[p];
      const int joined = sets.of(static_cast<int>(p));
      Unit& unit = units[alone[joined] ? static_cast<int>(p) : joined];
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
    // Of units at the same distance, whatever rounding says, the first goes first.
    constexpr double same = 1e-4;
    std::stable_sort(units_.begin(), units_.end(), [](const Unit& a, const Unit& b) {
      return std::lround(a.distance / same) < std::lround(b.distance / same);
    });
  }

  /// Which way each point of a unit is to be moved, of unit length; `flat` tells whether all go the
  /// same.
  std::vector<Vec3> ways(const Unit& unit, bool& flat) const {
    const std::vector<Vec3>& at = placement_.placed;
    Vec3 sum = Vec3::Zero();
    double areas = 0;
    for (const Triangle& c : unit.triangles) {
      const Vec3 area = (at[c[1]] - at[c[0]]).cross(at[c[2]] - at[c[0]]);
      sum += area;
      areas += area.norm();
    }
    flat = sum.norm() > flat_share * areas || skeleton_ == nullptr;
    std::vector<Vec3> ways(unit.points.size());
    if (flat) {
      Vec3 way = sum.norm() > 0 ? Vec3(sum.normalized()) : Vec3::UnitZ();
      // The right side faces away from the body, unless it surely stands on the wrong one.
      double out = 0;
      for (const int p : unit.points) {
        out +=
            distance_.at(at[p] + reach * way).distance - distance_.at(at[p] - reach * way).distance;
      }
      if (out < -0.5 * reach * static_cast<double>(unit.points.size())) way = -way;
      std::fill(ways.begin(), ways.end(), way);
      return ways;
    }
    const Bones bones(*skeleton_, panel_parts(garment_, *skeleton_)[unit.panels.front()]);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const Vec3& p = at[unit.points[i]];
      const Vec3 away = p - bones.at(bones.foot(p)).first;
      ways[i] = away.norm() > 0 ? Vec3(away.normalized()) : Vec3::Zero();
    }
    return ways;
  }

  /// All panels' points, those of the unit moved on.
  std::vector<Vec3> moved(const Unit& unit, const std::vector<Vec3>& ways, int steps) const {
    std::vector<Vec3> points = placement_.placed;
    for (std::size_t i = 0; i < ways.size(); ++i) points[unit.points[i]] += steps * step * ways[i];
    return points;
  }

  /// Whether any of the triangles meets the collider or is inside of it.
  bool meets_subject(const std::vector<Triangle>& triangles,
                     const std::vector<Vec3>& points) const {
    TriangleMesh near{points, {}};
    for (const Triangle& corners : triangles) {
      double longest = 0;
      double least = 1e300;
      for (int i = 0; i < 3; ++i) {
        const Vec3& p = points[corners[i]];
        const double at = distance_.at(p).distance;
        if (at < surely_inside) return true;
        least = std::min(least, distance_.lower_bound(at));
        longest = std::max(longest, (p - points[corners[(i + 1) % 3]]).norm());
      }
      if (least < longest) near.triangles.push_back(corners);
    }
    return !near.triangles.empty() && !intersections(near, collider_).empty();
  }

  bool is_clear(const Unit& unit, const std::vector<char>& settled,
                const std::vector<Vec3>& points) const {
    if (meets_subject(unit.triangles, points)) return false;
    std::vector<char> mine(garment_.panels.size(), 0);
    for (const int p : unit.panels) mine[p] = 1;
    const std::vector<std::pair<int, int>> crossing = crossing_panels(garment_, points);
    return std::none_of(crossing.begin(), crossing.end(), [&](const std::pair<int, int>& pair) {
      const auto [a, b] = pair;
      return (mine[a] && (settled[b] || mine[b])) || (mine[b] && settled[a]);
    });
  }

  bool place(const Unit& unit, const std::vector<char>& settled) {
    if (is_clear(unit, settled, placement_.placed)) return true;
    bool flat = true;
    const std::vector<Vec3> out = ways(unit, flat);
    const int most = flat ? max_steps : max_widening;
    for (int steps = 1; steps <= most; ++steps) {
      std::vector<Vec3> points = moved(unit, out, steps);
      if (!is_clear(unit, settled, points)) continue;
      int best = steps;
      // Just clear is too near to be moved about.
      std::vector<Vec3> farther = moved(unit, out, steps + 1);
      if (is_clear(unit, settled, farther)) {
        points = std::move(farther);
        ++best;
      }
      placement_.placed = std::move(points);
      for (const int p : unit.panels) placement_.moved_clear[name(p)] += best * step;
      return true;
    }
    return false;
  }

  const PanelMesh& garment_;
  const TriangleMesh& collider_;
  const DistanceGrid& distance_;
  const Skeleton* skeleton_;
  Placement& placement_;
  std::vector<Unit> units_;
};

/// The garment's triangles, sewn points that are in one place made one.
std::vector<Triangle> joined(const PanelMesh& garment, const std::vector<Vec3>& placed) {
  DisjointSets sets(placed.size());
  for_joined_points(garment, placed, [&](int a, int b) { sets.join(a, b); });
  std::vector<Triangle> triangles = garment.triangles;
  for (Triangle& t : triangles) {
    for (int& corner : t) corner = sets.of(corner);
  }
  return triangles;
}

}  // namespace

std::vector<std::pair<int, int>> crossing_panels(const PanelMesh& garment,
                                                 const std::vector<Vec3>& placed) {
  std::vector<int> panel_of;
  for (std::size_t i = 0; i < garment.panels.size(); ++i) {
    panel_of.insert(panel_of.end(), garment.panels[i].triangles, static_cast<int>(i));
  }
  std::set<std::pair<int, int>> pairs;
  for (const auto& [s, t] : self_intersections({placed, joined(garment, placed)})) {
    if (panel_of[s] != panel_of[t]) pairs.insert(std::minmax(panel_of[s], panel_of[t]));
  }
  return {pairs.begin(), pairs.end()};
}

void resolve_intersections(const PanelMesh& garment, const TriangleMesh& collider,
                           const DistanceGrid& distance, const Skeleton* skeleton,
                           Placement& placement) {
  Clearing clearing(garment, collider, distance, skeleton, placement);
  if (clearing.is_due()) clearing.run();
}

}  // namespace toile
