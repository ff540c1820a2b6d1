#include "geometry/body/bones.h"

#include <algorithm>
#include <limits>

namespace toile {

Bones::Bones(const Skeleton& skeleton, BodyPart part) {
  const std::string name = name_of(part);
  for (const Segment& segment : skeleton.segments) {
    if (segment.part != name) continue;
    if (joints.empty()) joints.push_back(skeleton.joint(segment.from));
    joints.push_back(skeleton.joint(segment.to));
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    along.push_back(i == 0 ? 0 : along.back() + (joints[i] - joints[i - 1]).norm());
  }
}

double Bones::distance(const Vec3& p) const {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
    const Vec3 bone = joints[i + 1] - joints[i];
    const double t = std::clamp((p - joints[i]).dot(bone) / bone.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (joints[i] + t * bone - p).norm());
  }
  return nearest;
}

double Bones::foot(const Vec3& p) const {
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

std::pair<Vec3, Vec3> Bones::at(double s) const {
  std::size_t i = 0;
  while (i + 2 < joints.size() && s > along[i + 1]) ++i;
  const Vec3 direction = (joints[i + 1] - joints[i]).normalized();
  return {joints[i] + (s - along[i]) * direction, direction};
}

std::pair<Vec3, Vec3> Bones::average(double low, double high) const {
  Vec3 middle = Vec3::Zero();
  Vec3 direction = Vec3::Zero();
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
    const double from = i == 0 ? low : std::max(low, along[i]);
    const double to = i + 2 == joints.size() ? high : std::min(high, along[i + 1]);
    if (!(from < to)) continue;
    const Vec3 bone = (joints[i + 1] - joints[i]).normalized();
    middle += (to - from) * (joints[i] + (0.5 * (from + to) - along[i]) * bone);
    direction += (to - from) * bone;
  }
  return {middle / (high - low), direction.normalized()};
}

}  // namespace toile
