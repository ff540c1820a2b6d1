#include "geometry/body/mannequin/bend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

Bend::Bend(const Vec3& joint, const Vec3& along, const Vec3& toward, double angle, double reach)
    : joint_(joint), along_(along), toward_(toward), angle_(angle), reach_(reach) {
  if (straight()) return;
  radius_ = reach / std::tan(angle / 2);
  centre_ = joint - reach * along + radius_ * toward;
  whole_ = {joint, turned_by(angle)};
}

Eigen::Matrix3d Bend::turned_by(double angle) const {
  return Eigen::AngleAxisd(angle, along_.cross(toward_)).toRotationMatrix();
}

Eigen::Matrix3d Bend::turn(const Vec3& rest) const {
  if (straight()) return Eigen::Matrix3d::Identity();
  const double beyond = (rest - joint_).dot(along_);
  const double share = std::clamp((beyond + reach_) / (2 * reach_), 0.0, 1.0);
  return turned_by(share * angle_);
}

Vec3 Bend::posed(const Vec3& rest) const {
  if (straight()) return rest;
  const double beyond = (rest - joint_).dot(along_);
  if (beyond <= -reach_) return rest;
  if (beyond >= reach_) return whole_.posed(rest);
  const Vec3 in_section = rest - beyond * along_ - reach_ * along_ - centre_;
  return centre_ + turn(rest) * in_section;
}

Vec3 Bend::rest(const Vec3& posed) const {
  if (straight()) return posed;
  const Vec3 from_centre = posed - centre_;
  const double ahead = from_centre.dot(along_);
  const double out = -from_centre.dot(toward_);
  double turned = std::atan2(ahead, out);
  // Beyond the centre, where there is no limb, the two bones get half of space each.
  if (turned < angle_ / 2 - std::numbers::pi) turned += 2 * std::numbers::pi;
  if (turned <= 0) return posed;
  if (turned >= angle_) return whole_.rest(posed);
  const Vec3 aside = from_centre - ahead * along_ + out * toward_;
  return centre_ + aside - std::hypot(ahead, out) * toward_ + 2 * reach_ * turned / angle_ * along_;
}

}  // namespace toile
