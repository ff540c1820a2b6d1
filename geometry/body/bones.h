// The bones of one body part as a polyline, along which panels are laid.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/body/skeleton.h"

namespace toile {

/// The bones of one part, end to end. The first and the last bone are extended beyond their ends.
/// Arc lengths are in metres from the first joint, negative before it.
struct Bones {
  std::vector<Vec3> joints;   ///< metres; empty if the skeleton lacks the part
  std::vector<double> along;  ///< arc length at each joint

  /// If the skeleton lacks `part`, no other member may be called.
  Bones(const Skeleton& skeleton, BodyPart part);

  /// Metres from the bones without their extensions.
  double distance(const Vec3& p) const;

  /// Arc length of the point closest to `p` on the bones and their extensions.
  double foot(const Vec3& p) const;

  /// The point at an arc length, and the bone's unit direction there.
  std::pair<Vec3, Vec3> at(double s) const;

  /// The middle and the unit direction of the straight line that stands for the bones between the
  /// arc lengths `low` and `high`, low < high. Each is the mean over the bones, weighted by length
  /// [Zhong & Xu 2009, "the average orientation of the multiple joint connections"].
  std::pair<Vec3, Vec3> average(double low, double high) const;
};

}  // namespace toile
