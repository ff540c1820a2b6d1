// How a joint moves the space around it: a turn as a whole, or a bend along an arc.
#pragma once

#include <Eigen/Core>

#include "geometry/types.h"

namespace toile {

/// Turns all space about a joint. `rotation` is orthonormal.
struct Turn {
  Vec3 joint = Vec3::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  Vec3 posed(const Vec3& rest) const { return joint + rotation * (rest - joint); }
  Vec3 rest(const Vec3& posed) const { return joint + rotation.transpose() * (posed - joint); }
};

/// Bends a limb at a joint. More than `reach` metres before and after the joint, the bones move
/// rigidly; the bone after it turns about the joint. In between, cross-sections square to the limb
/// follow an arc tangent to both bones. A section keeps its shape and its girth. The arc's length
/// is angle / (2 tan(angle / 2)) times that of the straight limb.
///
/// The map is one-to-one where the limb on the inside of the bend is thinner than
/// reach / tan(angle / 2).
class Bend {
 public:
  /// `along` points down the limb at rest. `toward` points to where the bone after the joint goes.
  /// They are orthonormal. `angle` is in radians, in [0, pi).
  Bend(const Vec3& joint, const Vec3& along, const Vec3& toward, double angle, double reach);

  /// The posed place of a point at rest.
  Vec3 posed(const Vec3& rest) const;
  /// The place at rest of a posed point.
  Vec3 rest(const Vec3& posed) const;
  /// The rotation of the section through a point of the limb at rest.
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
  Turn whole_;  // of the bone after the joint
};

}  // namespace toile
