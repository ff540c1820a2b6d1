#include "cloth/start/centre_sleeves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/start/constants.h"
#include "geometry/angles.h"
#include "geometry/body/bones.h"

namespace toile {

namespace {

/// The plane of front and back, along an arm.
struct ArmPlane {
  Vec3 shoulder;
  Vec3 along;  ///< unit vector down the arm
  Vec3 up;     ///< unit vector square to it

  ArmPlane(const Skeleton& skeleton, const std::string& part) {
    const Bones bones(skeleton, part);
    shoulder = bones.joints.front();
    along = bones.joints.back() - shoulder;
    along.z() = 0;
    along.normalize();
    up = along.x() >= 0 ? Vec3(-along.y(), along.x(), 0) : Vec3(along.y(), -along.x(), 0);
  }
  Vec2 at(const Vec3& p) const { return {along.dot(p - shoulder), up.dot(p - shoulder)}; }
  /// Turns `p` by `angle` about `pivot` and lifts it, all in the plane.
  Vec2 moved(const Vec2& p, const Vec2& pivot, double angle, double lift) const {
    const Vec2 r = p - pivot;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return pivot + Vec2(c * r.x() - s * r.y(), s * r.x() + c * r.y() + lift);
  }
};

/// The outline of an arm before the plane: its lowest and highest points along it.
class ArmOutline {
 public:
  ArmOutline(const TriangleMesh& skin, const Skeleton& skeleton, const std::string& part,
             const ArmPlane& plane) {
    const Bones arm(skeleton, part);
    const Bones torso(skeleton, "torso");
    const double sign = plane.along.x() >= 0 ? 1 : -1;
    for (const Vec3& p : skin.points) {
      if (sign * (p.x() - plane.shoulder.x()) < 0) continue;
      const Vec2 at = plane.at(p);
      if (at.x() < armpit_length || arm.distance(p) > max_arm_radius) continue;
      if (arm.distance(p) > torso.distance(p)) continue;
      const auto bin = static_cast<std::size_t>(at.x() / bin_width);
      if (bin >= low_.size()) {
        low_.resize(bin + 1, std::numeric_limits<double>::infinity());
        high_.resize(bin + 1, -std::numeric_limits<double>::infinity());
      }
      low_[bin] = std::min(low_[bin], at.y());
      high_[bin] = std::max(high_[bin], at.y());
    }
  }

  /// Metres by which a point is too near to the outline, from above or from below.
  double lack(const Vec2& p, bool above) const {
    if (p.x() < 0) return 0;
    const auto bin = static_cast<std::size_t>(p.x() / bin_width);
    if (bin >= low_.size() || high_[bin] < low_[bin]) return 0;
    const double gap = above ? p.y() - high_[bin] : low_[bin] - p.y();
    return std::max(sleeve_clearance - gap, 0.0);
  }

 private:
  static constexpr double bin_width = 0.01;       // metres
  static constexpr double max_arm_radius = 0.15;  // metres from the bones, hands included
  std::vector<double> low_;
  std::vector<double> high_;
};

/// A point of a seam that closes above or below the arm.
struct SeamPoint {
  Vec2 at;
  bool above;
};

}  // namespace

std::map<std::string, double> centre_sleeves(const PanelMesh& garment,
                                             const std::vector<std::string>& part_of_point,
                                             const TriangleMesh& skin, const Skeleton& skeleton,
                                             std::vector<Vec3>& placed) {
  std::map<std::string, double> moved;
  for (const char* part : {"left_arm", "right_arm"}) {
    if (Bones(skeleton, part).joints.empty()) continue;
    const ArmPlane plane(skeleton, part);
    std::vector<int> points;
    Vec2 middle = Vec2::Zero();
    for (const MeshedPanel& panel : garment.panels) {
      if (panel.placement.by_part() || part_of_point[panel.first_point] != part) continue;
      for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
        points.push_back(p);
        middle += plane.at(placed[p]);
      }
    }
    if (points.empty()) continue;
    middle /= static_cast<double>(points.size());
    Vec2 pivot = Vec2::Zero();
    int at_armhole = 0;
    std::vector<SeamPoint> seams;
    for (const MeshedSeam& seam : garment.seams) {
      const bool mine_a = part_of_point[seam.a.front()] == part;
      const bool mine_b = part_of_point[seam.b.front()] == part;
      if (mine_a != mine_b) {
        for (const int p : mine_a ? seam.a : seam.b) pivot += plane.at(placed[p]);
        at_armhole += static_cast<int>(seam.a.size());
      }
      if (!mine_a || !mine_b) continue;
      Vec2 seam_middle = Vec2::Zero();
      double apart = 0;
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        seam_middle += 0.5 * (plane.at(placed[seam.a[i]]) + plane.at(placed[seam.b[i]]));
        apart += std::abs(placed[seam.a[i]].z() - placed[seam.b[i]].z());
      }
      const auto count = static_cast<double>(seam.a.size());
      if (apart < min_sleeve_depth * count) continue;
      // Which side of the arm it closes on is told by the panels beside it: their cloth lies there.
      Vec2 beside = Vec2::Zero();
      double weight = 0;
      for (const int p : points) {
        if (std::abs(plane.at(placed[p]).x() - seam_middle.x() / count) > 0.05) continue;
        beside += plane.at(placed[p]);
        ++weight;
      }
      if (weight == 0) continue;
      const bool above = seam_middle.y() / count > beside.y() / weight;
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        seams.push_back({plane.at(placed[seam.a[i]]), above});
        seams.push_back({plane.at(placed[seam.b[i]]), above});
      }
    }
    const bool has_both = std::ranges::any_of(seams, [](const SeamPoint& s) { return s.above; }) &&
                          std::ranges::any_of(seams, [](const SeamPoint& s) { return !s.above; });
    if (!has_both) continue;
    pivot = at_armhole > 0 ? Vec2(pivot / at_armhole) : middle;
    const ArmOutline outline(skin, skeleton, part, plane);
    const auto cost = [&](double angle, double lift) {
      double sum = 0;
      for (const SeamPoint& seam : seams) {
        const double lack = outline.lack(plane.moved(seam.at, pivot, angle, lift), seam.above);
        sum += lack * lack;
      }
      const double motion = lift * lift + 0.1 * angle * angle;
      return sum + centring_reluctance * motion * static_cast<double>(seams.size());
    };
    double best = cost(0, 0);
    double angle = 0;
    double lift = 0;
    for (int a = -max_sleeve_degrees; a <= max_sleeve_degrees; ++a) {
      for (int l = -max_sleeve_lifts; l <= max_sleeve_lifts; ++l) {
        const double radians = to_radians(a);
        const double found = cost(radians, l * sleeve_lift_step);
        if (found >= best) continue;
        best = found;
        angle = radians;
        lift = l * sleeve_lift_step;
      }
    }
    for (const int p : points) {
      const Vec2 from = plane.at(placed[p]);
      const Vec2 way = plane.moved(from, pivot, angle, lift) - from;
      placed[p] += way.x() * plane.along + way.y() * plane.up;
    }
    moved[part] = (plane.moved(middle, pivot, angle, lift) - middle).norm();
  }
  return moved;
}

}  // namespace toile
