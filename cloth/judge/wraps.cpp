#include "cloth/judge/wraps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "cloth/judge/constants.h"
#include "cloth/judge/measures.h"
#include "cloth/scene/constants.h"
#include "cloth/scene/scene.h"
#include "cloth/start/panel_parts.h"
#include "geometry/body/bones.h"

namespace toile {

namespace {

/// Metres along the bones.
struct Interval {
  double low;
  double high;
};

/// Metres, per node: the shortest path from `sources` on the flat panels of one part, over sewn
/// seams. Infinite for nodes that none of the panels has.
std::vector<double> flat_distances(const PanelMesh& garment, const DressedGarment& dressed,
                                   const std::vector<char>& panel_counts,
                                   const std::vector<int>& sources) {
  std::vector<std::vector<std::pair<int, double>>> neighbours(dressed.points.size());
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    if (!panel_counts[p]) continue;
    const MeshedPanel& panel = garment.panels[p];
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double length =
            (garment.flat[garment.triangles[t][i]] - garment.flat[garment.triangles[t][j]]).norm();
        neighbours[dressed.triangles[t][i]].emplace_back(dressed.triangles[t][j], length);
        neighbours[dressed.triangles[t][j]].emplace_back(dressed.triangles[t][i], length);
      }
    }
  }
  std::vector<double> distance(dressed.points.size(), std::numeric_limits<double>::infinity());
  using Reached = std::pair<double, int>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
  for (const int source : sources) {
    distance[source] = 0;
    next.emplace(0, source);
  }
  while (!next.empty()) {
    const auto [so_far, node] = next.top();
    next.pop();
    if (so_far > distance[node]) continue;
    for (const auto& [to, length] : neighbours[node]) {
      if (so_far + length >= distance[to]) continue;
      distance[to] = so_far + length;
      next.emplace(distance[to], to);
    }
  }
  return distance;
}

/// The stretch of bone that a part's panels are meant to cover.
struct CoveredBone {
  Interval stretch;
  double slid = 0;  ///< metres down along the bones from where they were placed
};

/// The stretch for a skirt, which hangs from wherever its top lies. `placed` and `lies` are metres
/// along the torso's bones: its top as placed and as dressed. `length` is its own on the flat. A
/// top that slid off the torso or too far does not count: the skirt does not cover what it should.
CoveredBone covered_by_skirt(double placed, double lies, double length, double neck) {
  const double slid = placed - lies;
  const double max_slid = std::max(max_slid_share * length, hand_breadth);
  const bool counts = lies > 0 && lies < neck && std::abs(slid) < max_slid;
  const double top = counts ? lies : placed;
  return {{top - limb_cover_end * length, top - limb_cover_begin * length}, slid};
}

CoveredBone covered_bone(const PanelMesh& garment, const DressedGarment& dressed,
                         const std::vector<std::string>& parts, const std::string& part,
                         const Bones& bones, const Skeleton& skeleton) {
  const bool torso = part == "torso";
  std::vector<char> counts;
  for (const std::string& p : parts) counts.push_back(p == part);
  std::vector<char> here(dressed.points.size(), 0);
  std::vector<char> elsewhere(dressed.points.size(), 0);
  std::vector<double> placed_along(dressed.points.size(), 0);
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const bool counted = counts[dressed.panel_of_triangle[t]] != 0;
    for (int i = 0; i < 3; ++i) {
      const int node = dressed.triangles[t][i];
      (counted ? here : elsewhere)[node] = 1;
      // The torso's bones run up, so its hem is low. A limb's bones run out, so its hem is far.
      if (counted) {
        const double along = bones.foot(garment.placed[garment.triangles[t][i]]);
        placed_along[node] = torso ? -along : along;
      }
    }
  }
  double top = std::numeric_limits<double>::max();
  double hem = std::numeric_limits<double>::lowest();
  for (std::size_t n = 0; n < here.size(); ++n) {
    if (!here[n]) continue;
    top = std::min(top, placed_along[n]);
    hem = std::max(hem, placed_along[n]);
  }
  std::vector<int> sources;
  for (std::size_t n = 0; n < here.size(); ++n) {
    const bool source = torso ? placed_along[n] < top + end_depth : elsewhere[n] != 0;
    if (here[n] && source) sources.push_back(static_cast<int>(n));
  }
  const std::vector<double> distances = flat_distances(garment, dressed, counts, sources);
  double length = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < here.size(); ++n) {
    if (here[n] && placed_along[n] > hem - end_depth) length = std::min(length, distances[n]);
  }
  const double armpit = skeleton.joint("chest").y();
  if (torso) {
    const double from = bones.foot(skeleton.joint("chest"));
    // Panels that start below the armpits have no shoulders to hang from.
    if (-top < from) {
      double placed = 0;
      double lies = 0;
      for (const int n : sources) {
        placed -= placed_along[n] / sources.size();
        lies += bones.foot(dressed.points[n]) / sources.size();
      }
      return covered_by_skirt(placed, lies, length, bones.along.back());
    }
    const double below = length - (skeleton.joint("neck").y() - armpit);
    return {{from - torso_cover_end * below, from - torso_cover_begin * below}};
  }
  const bool arm = part.ends_with("arm");
  Vec3 fork = bones.joints.front();
  fork.y() = arm ? armpit : skeleton.joint("pelvis").y();
  const double from = bones.foot(fork);
  return {{from + limb_cover_begin * length, from + limb_cover_end * length}};
}

/// The share of directions around the station, square to the axis, whose ray meets a triangle.
double share_met(const Vec3& station, const Vec3& axis, const std::vector<Vec3>& points,
                 const std::vector<Triangle>& triangles) {
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.cross(u);
  std::array<bool, wrap_directions> met{};
  for (const Triangle& t : triangles) {
    double height[3];
    for (int i = 0; i < 3; ++i) height[i] = axis.dot(points[t[i]] - station);
    Vec2 crossing[2];
    int crossings = 0;
    for (int i = 0; i < 3 && crossings < 2; ++i) {
      const int j = (i + 1) % 3;
      if ((height[i] < 0) == (height[j] < 0)) continue;
      const double w = height[i] / (height[i] - height[j]);
      const Vec3 p = (1 - w) * points[t[i]] + w * points[t[j]] - station;
      crossing[crossings++] = {p.dot(u), p.dot(v)};
    }
    if (crossings < 2) continue;
    constexpr double unit = wrap_directions / (2 * std::numbers::pi);
    const double from = unit * std::atan2(crossing[0].y(), crossing[0].x());
    double turn = unit * std::atan2(crossing[1].y(), crossing[1].x()) - from;
    if (turn > wrap_directions / 2.0) turn -= wrap_directions;
    if (turn < -wrap_directions / 2.0) turn += wrap_directions;
    const double low = std::min(from, from + turn);
    for (int d = static_cast<int>(std::ceil(low)); d <= low + std::abs(turn); ++d) {
      met[(d + 2 * wrap_directions) % wrap_directions] = true;
    }
  }
  return static_cast<double>(std::count(met.begin(), met.end(), true)) / wrap_directions;
}

}  // namespace

std::vector<WrapFigure> measure_wraps(const PanelMesh& garment, const DressedGarment& dressed,
                                      const Skeleton& skeleton) {
  const std::vector<std::string> parts = panel_parts(garment, skeleton);
  std::vector<WrapFigure> figures;
  for (const std::string_view name : body_parts) {
    const std::string part(name);
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) continue;
    std::vector<Triangle> triangles;
    for (std::size_t p = 0; p < garment.panels.size(); ++p) {
      if (parts[p] != part) continue;
      const auto first = dressed.triangles.begin() + garment.panels[p].first_triangle;
      triangles.insert(triangles.end(), first, first + garment.panels[p].triangles);
    }
    const Bones bones(skeleton, part);
    if (bones.joints.empty()) continue;
    const CoveredBone covered = covered_bone(garment, dressed, parts, part, bones, skeleton);
    const Interval& stretch = covered.stretch;
    // Panels that are joined to no torso, or end where they begin, have no stretch to cover.
    if (!(stretch.low < stretch.high) || !std::isfinite(stretch.high - stretch.low)) continue;
    WrapFigure figure{part, stretch.low, stretch.high};
    figure.slid = covered.slid;
    for (int i = 0; i < wrap_stations; ++i) {
      const double s = stretch.low + (i + 0.5) / wrap_stations * (stretch.high - stretch.low);
      const auto [station, axis] = bones.at(s);
      figure.fraction += share_met(station, axis, dressed.points, triangles) / wrap_stations;
    }
    // A sheet has one border, whatever its shape.
    figure.tube = border_loops(triangles, dressed.points.size()) > 1;
    figures.push_back(figure);
  }
  return figures;
}

}  // namespace toile
