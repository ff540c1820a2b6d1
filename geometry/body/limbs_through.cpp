#include "geometry/body/limbs_through.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace toile {

namespace {

/// Metres from the wrist past the finger tips.
constexpr double hand_length = 0.25;
/// Metres: farther than anything that is dressed.
constexpr double far_away = 1000;

using Path = std::vector<Vec3>;

Path head_path(const Skeleton& skeleton, double face) {
  const Vec3& neck = skeleton.joint("neck");
  const Vec3 looks_out = neck + face * (skeleton.joint("head") - neck);
  return {skeleton.joint("waist"), skeleton.joint("chest"), neck, looks_out,
          looks_out + Vec3(0, 0, far_away)};
}

Path arm_path(const Skeleton& skeleton, const std::string& side) {
  const Vec3& elbow = skeleton.joint(side + "elbow");
  const Vec3& wrist = skeleton.joint(side + "wrist");
  const Vec3 tip = wrist + hand_length * (wrist - elbow).normalized();
  return {skeleton.joint("waist"),
          skeleton.joint("chest"),
          skeleton.joint(side + "shoulder"),
          elbow,
          wrist,
          tip,
          tip + Vec3(side == "left_" ? far_away : -far_away, 0, 0)};
}

Path leg_path(const Skeleton& skeleton, const std::string& side) {
  const Vec3& ankle = skeleton.joint(side + "ankle");
  return {skeleton.joint("waist"), skeleton.joint(side + "hip"), skeleton.joint(side + "knee"),
          ankle, ankle - Vec3(0, far_away, 0)};
}

/// How often the loop passes in front of the path to the right, less how often to the left. Both
/// are seen along a fixed direction. Of two paths from one point to infinity the difference is
/// the linking number of the loop with both.
int crossings(const std::vector<Vec3>& loop, const Path& path) {
  // A direction that no pattern, body or coordinate plane is lined up with.
  static const Vec3 view = Vec3(0.3413, 0.2579, 0.9039).normalized();
  const Vec3 u = view.unitOrthogonal();
  const Vec3 v = view.cross(u);
  const auto seen = [&](const Vec3& p) { return Vec3(p.dot(u), p.dot(v), p.dot(view)); };
  const auto turn = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  int sum = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec3 a = seen(path[i]);
    const Vec3 b = seen(path[i + 1]);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 p = seen(loop[k]);
      const Vec3 q = seen(loop[(k + 1) % loop.size()]);
      const double p_side = turn(a, b, p);
      const double q_side = turn(a, b, q);
      if ((p_side >= 0) == (q_side >= 0)) continue;
      const double a_side = turn(p, q, a);
      const double b_side = turn(p, q, b);
      if ((a_side >= 0) == (b_side >= 0)) continue;
      const double on_loop = p_side / (p_side - q_side);
      const double on_path = a_side / (a_side - b_side);
      const double loop_depth = p.z() + on_loop * (q.z() - p.z());
      const double path_depth = a.z() + on_path * (b.z() - a.z());
      if (loop_depth > path_depth) sum += p_side >= 0 ? 1 : -1;
    }
  }
  return sum;
}

}  // namespace

bool has_all_limbs(const Skeleton& skeleton) {
  return std::ranges::all_of(joint_names, [&](std::string_view name) {
    return skeleton.joints.contains(std::string(name));
  });
}

LimbsThrough limbs_through(const std::vector<Vec3>& loop, const Skeleton& skeleton, double face) {
  const int head = crossings(loop, head_path(skeleton, face));
  return {crossings(loop, arm_path(skeleton, "left_")) != head,
          crossings(loop, arm_path(skeleton, "right_")) != head,
          crossings(loop, leg_path(skeleton, "left_")) != head,
          crossings(loop, leg_path(skeleton, "right_")) != head};
}

}  // namespace toile
