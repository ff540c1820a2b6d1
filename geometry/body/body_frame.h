// The frame in which a body is measured: it does not depend on how the body is turned.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// A body with its left at +x, its front at +z, its middle at x = 0, and its lowest point at y = 0.
struct BodyFrame {
  TriangleMesh mesh;                 ///< metres
  std::optional<Skeleton> skeleton;  ///< found in `mesh`; none: the surface lacks limbs
  std::string no_skeleton;           ///< why; empty: there is one
  /// A point p of the body comes to rotation * p + translation.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();
  double height = 0;  ///< metres
  /// Of a skeleton without an arm or a head: why, by part. Empty: it is whole, or there is none.
  std::map<std::string, std::string> missing = {};

  /// The point of the given body that came to `p`.
  Vec3 given(const Vec3& p) const { return rotation.transpose() * (p - translation); }
};

/// Turns `body`, which stands along y, about the vertical into its own frame. The first turn is by
/// the axis along which the surface spreads most. The second is by the joints that are found then,
/// the third by the toes. So a body turned by any angle gives the same frame, up to rounding. Of a
/// body with one arm, the trunk's width counts for the second turn. A body without a skeleton is
/// turned by its spread alone, and less than a quarter turn.
///
/// `body` is closed and outward-oriented, in metres; `name` is its place in messages. Throws Error
/// for an empty mesh. Costs find_skeleton() one to seven times.
BodyFrame body_frame(const TriangleMesh& body, const std::string& name);

/// The frame and the joints that `smooth` shows, a smoothed copy of `body`. Floor and height are
/// those of `body`.
BodyFrame body_frame(const TriangleMesh& body, const TriangleMesh& smooth, const std::string& name);

}  // namespace toile
