#include "cloth/start/centre_sleeves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

  ArmPlane(const Skeleton& skeleton, BodyPart part) {
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
  ArmOutline(const TriangleMesh& skin, const Skeleton& skeleton, BodyPart part,
             const ArmPlane& plane) {
    const Bones arm(skeleton, part);
    const Bones torso(skeleton, BodyPart::torso);
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

/// The panels of an arm, in its plane. Metres.
struct SleeveInPlane {
  std::vector<int> points;
  Vec2 middle{0, 0};             ///< mean of the points
  Vec2 pivot{0, 0};              ///< mean of the armhole's points, or the middle
  std::vector<SeamPoint> seams;  ///< of the seams that close around the arm

  bool closes_on_both_sides() const {
    return std::ranges::any_of(seams, &SeamPoint::above) &&
           !std::ranges::all_of(seams, &SeamPoint::above);
  }
};

/// Whether the cloth that lies beside a seam, within 5 cm along the arm, is below it; none: there
/// is no cloth.
std::optional<bool> is_above_cloth(const Vec2& seam, const std::vector<int>& points,
                                   const ArmPlane& plane, const std::vector<Vec3>& placed) {
  Vec2 beside = Vec2::Zero();
  double weight = 0;
  for (const int p : points) {
    if (std::abs(plane.at(placed[p]).x() - seam.x()) > 0.05) continue;
    beside += plane.at(placed[p]);
    ++weight;
  }
  if (weight == 0) return std::nullopt;
  return seam.y() > beside.y() / weight;
}

/// The panels of `part` that the skeleton did not position.
SleeveInPlane sleeve_of(const PanelMesh& garment, const std::vector<BodyPart>& part_of_point,
                        BodyPart part, const ArmPlane& plane, const std::vector<Vec3>& placed) {
  SleeveInPlane sleeve;
  for (const MeshedPanel& panel : garment.panels) {
    if (panel.placement.by_part() || part_of_point[panel.first_point] != part) continue;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      sleeve.points.push_back(p);
      sleeve.middle += plane.at(placed[p]);
    }
  }
  if (sleeve.points.empty()) return sleeve;
  sleeve.middle /= static_cast<double>(sleeve.points.size());
  int at_armhole = 0;
  for (const MeshedSeam& seam : garment.seams) {
    const bool mine_a = part_of_point[seam.a.front()] == part;
    const bool mine_b = part_of_point[seam.b.front()] == part;
    if (mine_a != mine_b) {
      for (const int p : mine_a ? seam.a : seam.b) sleeve.pivot += plane.at(placed[p]);
      at_armhole += static_cast<int>(seam.a.size());
    }
    if (!mine_a || !mine_b) continue;
    Vec2 middle = Vec2::Zero();
    double apart = 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      middle += 0.5 * (plane.at(placed[seam.a[i]]) + plane.at(placed[seam.b[i]]));
      apart += std::abs(placed[seam.a[i]].z() - placed[seam.b[i]].z());
    }
    const auto count = static_cast<double>(seam.a.size());
    if (apart < min_sleeve_depth * count) continue;
    // Which side of the arm it closes on is told by the panels beside it: their cloth lies there.
    const auto above = is_above_cloth(middle / count, sleeve.points, plane, placed);
    if (!above) continue;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      sleeve.seams.push_back({plane.at(placed[seam.a[i]]), *above});
      sleeve.seams.push_back({plane.at(placed[seam.b[i]]), *above});
    }
  }
  sleeve.pivot = at_armhole > 0 ? Vec2(sleeve.pivot / at_armhole) : sleeve.middle;
  return sleeve;
}

/// A turn about the armhole, radians, and a lift square to the arm, metres.
struct SleeveMove {
  double angle = 0;
  double lift = 0;
};

/// The move after which the seams are the least too near to the arm.
SleeveMove best_move(const SleeveInPlane& sleeve, const ArmPlane& plane,
                     const ArmOutline& outline) {
  const auto cost = [&](double angle, double lift) {
    double sum = 0;
    for (const SeamPoint& seam : sleeve.seams) {
      const double lack = outline.lack(plane.moved(seam.at, sleeve.pivot, angle, lift), seam.above);
      sum += lack * lack;
    }
    const double motion = lift * lift + 0.1 * angle * angle;
    return sum + centring_reluctance * motion * static_cast<double>(sleeve.seams.size());
  };
  SleeveMove move;
  double best = cost(0, 0);
  for (int a = -max_sleeve_degrees; a <= max_sleeve_degrees; ++a) {
    for (int l = -max_sleeve_lifts; l <= max_sleeve_lifts; ++l) {
      const SleeveMove tried = {to_radians(a), l * sleeve_lift_step};
      const double found = cost(tried.angle, tried.lift);
      if (found >= best) continue;
      best = found;
      move = tried;
    }
  }
  return move;
}

}  // namespace

std::map<BodyPart, double> centre_sleeves(const PanelMesh& garment,
                                          const std::vector<BodyPart>& part_of_point,
                                          const TriangleMesh& skin, const Skeleton& skeleton,
                                          std::vector<Vec3>& placed) {
  std::map<BodyPart, double> moved;
  for (const BodyPart part : {BodyPart::left_arm, BodyPart::right_arm}) {
    if (Bones(skeleton, part).joints.empty()) continue;
    const ArmPlane plane(skeleton, part);
    const SleeveInPlane sleeve = sleeve_of(garment, part_of_point, part, plane, placed);
    if (!sleeve.closes_on_both_sides()) continue;
    const SleeveMove move = best_move(sleeve, plane, ArmOutline(skin, skeleton, part, plane));
    const auto way = [&](const Vec2& from) -> Vec2 {
      return plane.moved(from, sleeve.pivot, move.angle, move.lift) - from;
    };
    for (const int p : sleeve.points) {
      const Vec2 by = way(plane.at(placed[p]));
      placed[p] += by.x() * plane.along + by.y() * plane.up;
    }
    moved[part] = way(sleeve.middle).norm();
  }
  return moved;
}

}  // namespace toile
