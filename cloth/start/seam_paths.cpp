#include "cloth/start/seam_paths.h"

#include <algorithm>

#include "geometry/parallel.h"

namespace toile {

namespace {

/// Metres between two looks along a way; what it grazes for less than that does not bar it.
constexpr double min_step = 0.02;
/// Metres down the arm from the joint of the shoulder, over which seams have to come.
constexpr double armpit = 0.1;

}  // namespace

SeamPaths::SeamPaths(const PanelMesh& garment, const std::vector<Vec3>& placed,
                     const std::vector<double>& lifted, const DistanceGrid& body,
                     const Skeleton* skeleton)
    : placed_(placed), lifted_(lifted), body_(body) {
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) ways_.push_back({seam.a[i], seam.b[i]});
  }
  if (skeleton == nullptr) return;
  torso_.emplace(*skeleton, "torso");
  for (const char* part : {"left_arm", "right_arm"}) {
    const Bones arm(*skeleton, part);
    if (!arm.joints.empty()) arms_.push_back(arm);
  }
}

int SeamPaths::obstructed(double lift) {
  std::vector<char> are_barred(ways_.size());
  parallel_for_chunks(ways_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) are_barred[i] = is_obstructed(ways_[i], lift);
  });
  return static_cast<int>(std::count(are_barred.begin(), are_barred.end(), 1));
}

int SeamPaths::at_arms() const {
  return static_cast<int>(
      std::count_if(ways_.begin(), ways_.end(), [](const Way& way) { return way.at_arm; }));
}

int SeamPaths::meeting_inside(double lift) const {
  return static_cast<int>(std::count_if(ways_.begin(), ways_.end(), [&](const Way& way) {
    const Vec3 middle = 0.5 * (lifted_point(way.a, lift) + lifted_point(way.b, lift));
    return body_.at(middle).distance < meeting_clearance;
  }));
}

Vec3 SeamPaths::lifted_point(int point, double lift) const {
  return placed_[point] + Vec3(0, lifted_[point] * lift, 0);
}

/// Where the two meet they have to keep off the skin; on the way there they may touch it.
bool SeamPaths::is_obstructed(Way& way, double lift) const {
  if (way.at_arm) return true;
  const Vec3 from = lifted_point(way.a, lift);
  const Vec3 to = lifted_point(way.b, lift);
  bool obstructed = false;
  const auto look = [&](const Vec3& p, double least) {
    const double distance = body_.at(p).distance;
    if (distance < least) {
      obstructed = true;
      way.at_arm = way.at_arm || in_arm(p);
    }
    return distance;
  };
  look(0.5 * (from + to), meeting_clearance);
  const double length = (to - from).norm();
  for (double done = 0; done < length && !way.at_arm;) {
    const Vec3 p = from + done / length * (to - from);
    done += min_step;
    // What is obstructed already is asked for arms only.
    if (obstructed && !in_arm(p)) continue;
    done += std::max(body_.lower_bound(look(p, 0)) - min_step, 0.0);
  }
  return obstructed;
}

/// Of a point, if it is in the body.
bool SeamPaths::in_arm(const Vec3& p) const {
  return std::any_of(arms_.begin(), arms_.end(), [&](const Bones& arm) {
    return arm.foot(p) > armpit && arm.distance(p) < torso_->distance(p);
  });
}

}  // namespace toile
