// The bones of one body part as a line that panels are laid along.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/body/skeleton.h"

namespace toile {

/// The bones of one part, end to end; the first and the last one go on beyond their ends. Lengths
/// along them are in metres from the first joint, negative before it.
struct Bones {
  std::vector<Vec3> joints;   ///< of a part that the skeleton lacks: none, then ask nothing else
  std::vector<double> along;  ///< arc length at each joint

  Bones(const Skeleton& skeleton, const std::string& part);

  /// Metres from the bones themselves, not from what they would go on to.
  double distance(const Vec3& p) const;

  /// Arc length of the point's foot on the bones.
  double foot(const Vec3& p) const;

  /// The point at an arc length, and the bone's direction there.
  std::pair<Vec3, Vec3> at(double s) const;

  /// The one straight line for the stretch from `low` to `high`, low < high: its middle and its
  /// direction, each the mean over the bones of the stretch weighted by their lengths
  /// [Zhong & Xu 2009, "the average orientation of the multiple joint connections"].
  std::pair<Vec3, Vec3> average(double low, double high) const;
};

}  // namespace toile
