#include "cloth/judge/wraps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cloth/judge/constants.h"
#include "cloth/start/panel_parts.h"
#include "geometry/body/bones.h"

namespace toile {

namespace {

/// Metres along the bones.
struct Interval {
  double low;
  double high;
};

/// Metres along the bones between which a part's cloth lies: a few stray nodes at both ends are
/// left out. `nodes` are those of the part's panels.
Interval lies_along(const std::vector<int>& nodes, const std::vector<Vec3>& points,
                    const Bones& bones) {
  std::vector<double> feet;
  feet.reserve(nodes.size());
  for (const int n : nodes) feet.push_back(bones.foot(points[n]));
  std::ranges::sort(feet);
  const auto stray = static_cast<std::size_t>(stray_share * static_cast<double>(feet.size()));
  return {feet[stray], feet[feet.size() - 1 - stray]};
}

/// The middle of where the cloth lies, without what slants at its ends. Above the armpits or the
/// crotch cloth goes around more than one part, so that is left out, too.
Interval covered(Interval lies, BodyPart part, const Bones& bones, const Skeleton& skeleton) {
  if (part == BodyPart::torso) {
    lies.high = std::min(lies.high, bones.foot(skeleton.joint("chest")));
  } else if (part != BodyPart::head) {
    Vec3 fork = bones.joints.front();
    fork.y() = skeleton.joint(is_arm(part) ? "chest" : "pelvis").y();
    lies.low = std::max(lies.low, bones.foot(fork));
  }
  const double length = lies.high - lies.low;
  return {lies.low + limb_cover_begin * length, lies.low + limb_cover_end * length};
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

WrapMeasurement measure_wrap(const DressedGarment& dressed, const Skeleton& skeleton, BodyPart part,
                             const std::vector<char>& is_counted) {
  const Bones bones(skeleton, part);
  std::vector<Triangle> triangles;
  std::vector<int> nodes;
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    if (!is_counted[dressed.panel_of_triangle[t]]) continue;
    triangles.push_back(dressed.triangles[t]);
    nodes.insert(nodes.end(), dressed.triangles[t].begin(), dressed.triangles[t].end());
  }
  WrapMeasurement wrap{part};
  if (triangles.empty() || bones.joints.empty()) return wrap;
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const Interval stretch = covered(lies_along(nodes, dressed.points, bones), part, bones, skeleton);
  wrap.from = stretch.low;
  wrap.to = stretch.high;
  // Cloth that lies at another part only has no stretch of this one to cover.
  for (int i = 0; i < wrap_stations && stretch.low < stretch.high; ++i) {
    const double s = stretch.low + (i + 0.5) / wrap_stations * (stretch.high - stretch.low);
    const auto [station, axis] = bones.at(s);
    wrap.fraction += share_met(station, axis, dressed.points, triangles) / wrap_stations;
  }
  return wrap;
}

BareLevel barest_level(const DressedGarment& dressed, const Skeleton& skeleton,
                       const std::vector<char>& is_counted, double low, double high) {
  std::vector<Triangle> triangles;
  triangles.reserve(dressed.triangles.size());
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    if (is_counted[dressed.panel_of_triangle[t]]) triangles.push_back(dressed.triangles[t]);
  }
  const Bones bones(skeleton, BodyPart::torso);
  BareLevel barest;
  for (int i = 0; i < wrap_stations && low < high; ++i) {
    const double share =
        limb_cover_begin + (limb_cover_end - limb_cover_begin) * (i + 0.5) / wrap_stations;
    Vec3 level = skeleton.joint("waist");
    level.y() = low + share * (high - low);
    const Vec3 station = bones.at(bones.foot(level)).first;
    const double met = share_met(station, Vec3::UnitY(), dressed.points, triangles);
    if (met < barest.share) barest = {station.y(), met};
  }
  return barest;
}

std::vector<WrapMeasurement> measure_wraps(const PanelMesh& garment, const DressedGarment& dressed,
                                           const Skeleton& skeleton) {
  const std::vector<BodyPart> parts = panel_parts(garment, skeleton);
  std::vector<WrapMeasurement> wraps;
  for (const std::string_view name : body_parts) {
    const BodyPart part = body_part(name);
    std::vector<char> is_counted;
    is_counted.reserve(parts.size());
    for (const BodyPart p : parts) is_counted.push_back(p == part);
    if (std::ranges::count(is_counted, 1) == 0 || Bones(skeleton, part).joints.empty()) continue;
    wraps.push_back(measure_wrap(dressed, skeleton, part, is_counted));
  }
  return wraps;
}

}  // namespace toile
