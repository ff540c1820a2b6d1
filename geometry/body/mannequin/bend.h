// How a joint carries space with it: turned as a whole, or bent along an arc.
#pragma once

#include <Eigen/Core>

#include "geometry/types.h"

namespace toile {

/// Everything turned about a joint. `rotation` is orthonormal.
struct Turn {
  Vec3 joint = Vec3::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  Vec3 posed(const Vec3& rest) const { return joint + rotation * (rest - joint); }
  Vec3 rest(const Vec3& posed) const { return joint + rotation.transpose() * (posed - joint); }
};

/// A limb bent at a joint. Beyond `reach` before and after the joint both bones move rigidly, the
/// one behind turned about the joint; between, cross-sections square to the limb follow an arc that
/// is tangent to both bones. A section keeps its shape, so its girth too; along the limb the arc is
/// shorter than the straight way by angle / (2 tan(angle / 2)).
///
/// One-to-one as far as the limb is thinner, on the inside of the bend, than reach / tan(angle /
/// 2).
class Bend {
 public:
  /// `along` leads down the limb at rest, `toward` is where the bone behind goes: orthonormal.
  /// `angle` in radians, at least 0, below pi.
  Bend(const Vec3& joint, const Vec3& along, const Vec3& toward, double angle, double reach);

  Vec3 posed(const Vec3& rest) const;
  Vec3 rest(const Vec3& posed) const;
  /// How a section through that point of the limb at rest is turned.
  Eigen::Matrix3d turn(const Vec3& rest) const;

 private:
  bool straight() const { return angle_ < 1e-6; }
  Eigen::Matrix3d turned_by(double angle) const;

  Vec3 joint_;
  Vec3 along_;
  Vec3 toward_;
  double angle_;
  double reach_;
  double radius_ = 0;
  Vec3 centre_ = Vec3::Zero();
  Turn whole_;  // what the bone behind the joint does
};

}  // namespace toile
