#include "cloth/wraps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace toile {

namespace {

constexpr int stations = 32;
constexpr int directions = 360;
/// Share of the meant stretch left out at either end.
constexpr double trim = 0.1;

/// The bones of one part, end to end.
struct Bones {
  std::vector<Vec3> joints;
  std::vector<double> along;  // arc length at each joint

  explicit Bones(const Skeleton& skeleton, const std::string& part) {
    for (const Segment& segment : skeleton.segments) {
      if (segment.part != part) continue;
      if (joints.empty()) joints.push_back(skeleton.joint(segment.from));
      joints.push_back(skeleton.joint(segment.to));
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      along.push_back(i == 0 ? 0 : along.back() + (joints[i] - joints[i - 1]).norm());
    }
  }

  double distance(const Vec3& p) const {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
      const Vec3 bone = joints[i + 1] - joints[i];
      const double t = std::clamp((p - joints[i]).dot(bone) / bone.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (joints[i] + t * bone - p).norm());
    }
    return nearest;
  }

  /// Arc length of the point's foot on the bones; the first and last bone go on beyond their ends.
  double foot(const Vec3& p) const {
    double nearest = std::numeric_limits<double>::max();
    double at = 0;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
      const Vec3 bone = joints[i + 1] - joints[i];
      double t = (p - joints[i]).dot(bone) / bone.squaredNorm();
      if (i > 0) t = std::max(t, 0.0);
      if (i + 2 < joints.size()) t = std::min(t, 1.0);
      const double distance = (joints[i] + t * bone - p).norm();
      if (distance < nearest) {
        nearest = distance;
        at = along[i] + t * bone.norm();
      }
    }
    return at;
  }

  /// The point at an arc length, and the bone's direction there.
  std::pair<Vec3, Vec3> at(double s) const {
    std::size_t i = 0;
    while (i + 2 < joints.size() && s > along[i + 1]) ++i;
    const Vec3 direction = (joints[i + 1] - joints[i]).normalized();
    return {joints[i] + (s - along[i]) * direction, direction};
  }
};

struct Interval {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();

  void include(double s) {
    low = std::min(low, s);
    high = std::max(high, s);
  }
};

/// Panel that each material point lies in.
std::vector<int> panel_of_point(const PanelMesh& garment) {
  std::vector<int> panel(garment.flat.size(), 0);
  for (std::size_t i = 0; i < garment.panels.size(); ++i) {
    const MeshedPanel& p = garment.panels[i];
    std::fill_n(panel.begin() + p.first_point, p.points, static_cast<int>(i));
  }
  return panel;
}

/// The stretch of bone that the part's panels are meant to cover.
Interval meant_stretch(const PanelMesh& garment, const std::vector<std::string>& parts,
                       const std::string& part, const Bones& bones, const Skeleton& skeleton) {
  const std::vector<int> panel = panel_of_point(garment);
  Interval all;
  Interval common{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
  for (std::size_t p = 0; p < garment.placed.size(); ++p) {
    if (parts[panel[p]] == part) all.include(bones.foot(garment.placed[p]));
  }
  if (part == "torso") {
    common = {all.low, std::min(all.high, bones.foot(skeleton.joint("chest")))};
  } else {
    for (const MeshedSeam& seam : garment.seams) {
      if (parts[panel[seam.a[0]]] != part || parts[panel[seam.b[0]]] != part) continue;
      Interval run;
      for (const int p : seam.a) run.include(bones.foot(garment.placed[p]));
      for (const int p : seam.b) run.include(bones.foot(garment.placed[p]));
      if (run.high - run.low < 0.25 * (all.high - all.low)) continue;  // runs across the limb
      common.low = std::max(common.low, run.low);
      common.high = std::min(common.high, run.high);
    }
    if (!(common.low < common.high) || common.low < all.low) common = all;
  }
  const double cut = trim * (common.high - common.low);
  return {common.low + cut, common.high - cut};
}

/// Share of directions around the station whose ray meets one of the triangles.
double share_met(const Vec3& station, const Vec3& axis, const std::vector<Vec3>& points,
                 const std::vector<Triangle>& triangles) {
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.cross(u);
  std::array<bool, directions> met{};
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
    constexpr double unit = directions / (2 * std::numbers::pi);
    const double from = unit * std::atan2(crossing[0].y(), crossing[0].x());
    double turn = unit * std::atan2(crossing[1].y(), crossing[1].x()) - from;
    if (turn > directions / 2.0) turn -= directions;
    if (turn < -directions / 2.0) turn += directions;
    const double low = std::min(from, from + turn);
    for (int d = static_cast<int>(std::ceil(low)); d <= low + std::abs(turn); ++d) {
      met[(d + 2 * directions) % directions] = true;
    }
  }
  return static_cast<double>(std::count(met.begin(), met.end(), true)) / directions;
}

}  // namespace

std::vector<std::string> panel_parts(const PanelMesh& garment, const Skeleton& skeleton) {
  std::vector<std::string> parts;
  for (const MeshedPanel& panel : garment.panels) {
    if (!panel.part.empty()) {
      parts.push_back(panel.part);
      continue;
    }
    Vec3 middle = Vec3::Zero();
    double left = 0;
    double right = 0;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      middle += garment.placed[p];
      left = std::max(left, garment.placed[p].x());
      right = std::max(right, -garment.placed[p].x());
    }
    middle /= panel.points;
    const bool both_sides = std::min(left, right) > 0.15 * (left + right);
    std::string nearest = "torso";
    double distance = Bones(skeleton, nearest).distance(middle);
    for (const char* part : {"left_arm", "right_arm", "left_leg", "right_leg"}) {
      if (both_sides) break;
      const Bones bones(skeleton, part);
      if (bones.joints.empty() || bones.distance(middle) >= distance) continue;
      nearest = part;
      distance = bones.distance(middle);
    }
    parts.push_back(nearest);
  }
  return parts;
}

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
    const Interval stretch = meant_stretch(garment, parts, part, bones, skeleton);
    WrapFigure figure{part, stretch.low, stretch.high, 0};
    for (int i = 0; i < stations; ++i) {
      const double s = stretch.low + (i + 0.5) / stations * (stretch.high - stretch.low);
      const auto [station, axis] = bones.at(s);
      figure.fraction += share_met(station, axis, dressed.points, triangles) / stations;
    }
    figures.push_back(figure);
  }
  return figures;
}

}  // namespace toile
