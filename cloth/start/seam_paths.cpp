#include "cloth/start/seam_paths.h"

#include <algorithm>

#include "cloth/start/constants.h"
#include "geometry/parallel.h"

namespace toile {

SeamPaths::SeamPaths(const PanelMesh& garment, const std::vector<Vec3>& placed,
                     const std::vector<double>& lifted, const DistanceGrid& body,
                     const Skeleton* skeleton)
    : placed_(placed), lifted_(lifted), body_(body) {
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) paths_.push_back({seam.a[i], seam.b[i]});
  }
  if (skeleton == nullptr) return;
  torso_.emplace(*skeleton, BodyPart::torso);
  for (const BodyPart part : {BodyPart::left_arm, BodyPart::right_arm}) {
    const Bones arm(*skeleton, part);
    if (!arm.joints.empty()) arms_.push_back(arm);
  }
}

int SeamPaths::obstructed(double lift) {
  std::vector<char> are_obstructed(paths_.size());
  parallel_for_chunks(paths_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) are_obstructed[i] = is_obstructed(paths_[i], lift);
  });
  return static_cast<int>(std::count(are_obstructed.begin(), are_obstructed.end(), 1));
}

int SeamPaths::at_arms() const {
  return static_cast<int>(std::count_if(paths_.begin(), paths_.end(),
                                        [](const SeamPath& path) { return path.at_arm; }));
}

int SeamPaths::meeting_inside(double lift) const {
  return static_cast<int>(std::count_if(paths_.begin(), paths_.end(), [&](const SeamPath& path) {
    const Vec3 middle = 0.5 * (lifted_point(path.a, lift) + lifted_point(path.b, lift));
    return body_.at(middle).distance < meeting_clearance;
  }));
}

Vec3 SeamPaths::lifted_point(int point, double lift) const {
  return placed_[point] + Vec3(0, lifted_[point] * lift, 0);
}

/// The meeting place has to keep `meeting_clearance` from the skin. The rest of the path may touch
/// the skin.
bool SeamPaths::is_obstructed(SeamPath& path, double lift) const {
  if (path.at_arm) return true;
  const Vec3 from = lifted_point(path.a, lift);
  const Vec3 to = lifted_point(path.b, lift);
  bool obstructed = false;
  const auto probe = [&](const Vec3& p, double min_distance) {
    const double distance = body_.at(p).distance;
    if (distance < min_distance) {
      obstructed = true;
      path.at_arm = path.at_arm || in_arm(p);
    }
    return distance;
  };
  probe(0.5 * (from + to), meeting_clearance);
  const double length = (to - from).norm();
  for (double done = 0; done < length && !path.at_arm;) {
    const Vec3 p = from + done / length * (to - from);
    done += seam_path_step;
    // A path that is obstructed already is only probed in arms.
    if (obstructed && !in_arm(p)) continue;
    done += std::max(body_.lower_bound(probe(p, 0)) - seam_path_step, 0.0);
  }
  return obstructed;
}

/// Whether a point that is in the body is in an arm.
bool SeamPaths::in_arm(const Vec3& p) const {
  return std::any_of(arms_.begin(), arms_.end(), [&](const Bones& arm) {
    return arm.foot(p) > armpit_length && arm.distance(p) < torso_->distance(p);
  });
}

}  // namespace toile
