#include "geometry/body/skin_cores.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/adjacency.h"
#include "geometry/error.h"
#include "geometry/half_edges.h"

namespace toile {

namespace {

// Lengths are metres of a body that is `usual_height` tall. They were chosen on the bodies of
// tests/benchmarks/pose_table. A longer way to bend folds less and changes girths farther away.
constexpr double usual_height = 1.70;
// Radii of the limb to both sides of a joint that bend. With 1.3 the calf runs into the thigh at 90
// degrees, and a knee's girth is off by up to 21 %, with 1.5 by 16 %. With 1.7 girths of nine
// bodies that sit are off by 2.5 % at most, with 1.9 by 3.9 %.
constexpr double knee_reach = 1.7;
constexpr double elbow_reach = 1.3;
// Below the crotch and above the hip joint. With 0.06 below, belly and thighs of four mannequins
// that sit run through each other. With 0.10, girths of the thigh are 5 to 6 % off.
constexpr double below_crotch = 0.08;
// Below the crotch, where a fine mesh's legs are apart.
constexpr double crotch_margin = 0.01;
constexpr double above_hip = 0.10;
// To both sides of the middle. Its skin stays with the trunk, so that the crotch does.
constexpr double middle_strip = 0.012;
// Down the arm from the shoulder and from the armpit, and from the shoulder to the middle. With
// 0.03 less of each a raised arm folds the skin.
constexpr double arm_end = 0.12;
constexpr double below_armpit = 0.04;
constexpr double shoulder_width = 0.14;
// Below the armpits' level.
constexpr double side_length = 0.10;
// About the ankle and the ball of the foot. Their angles are small.
constexpr double above_ankle = 0.06;
constexpr double below_ankle = 0.015;
constexpr double before_ankle = 0.07;
constexpr double ball_reach = 0.022;
// Share of the foot's length from the heel to the ball.
constexpr double ball_share = 0.74;

class SkinCoreFinder {
 public:
  SkinCoreFinder(const TriangleMesh& body, const Skeleton& skeleton, const std::string& name)
      : body_(body),
        skeleton_(skeleton),
        name_(name),
        scale_(skeleton.joint("head").y() / usual_height),
        on_limb_(body.points.size(), false) {
    const std::vector<std::array<int, 2>> edges = unique_edges(body.triangles);
    neighbours_.assign(body.points.size(), [&edges](const auto& add) {
      for (const auto& [a, b] : edges) {
        add(a, b);
        add(b, a);
      }
    });
    if (!(scale_ > 0.1)) {
      throw Error(name, "has its head at the floor", "let clean-body put it on y = 0");
    }
    cores_.bone_of.assign(body.points.size(), SkinCores::no_bone);
  }

  SkinCores find() {
    for (const bool left : {true, false}) {
      find_leg(left);
      find_arm(left);
    }
    find_trunk();
    return std::move(cores_);
  }

 private:
  const Vec3& joint(bool left, const std::string& joint_name) const {
    return skeleton_.joint((left ? "left_" : "right_") + joint_name);
  }

  [[noreturn]] void fail(bool left, const std::string& limb) const {
    throw Error(name_,
                std::string("the ") + (left ? "left " : "right ") + limb +
                    " can't be told from the rest of the body",
                "pose a body that stands with arms and legs apart");
  }

  /// The points that satisfy `holds` and hang together with the one of them nearest to `seed`.
  template <class Holds>
  std::vector<int> connected(const Vec3& seed, const Holds& holds) const {
    int first = -1;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < body_.points.size(); ++i) {
      const double d = (body_.points[i] - seed).squaredNorm();
      if (d < nearest && holds(body_.points[i])) {
        nearest = d;
        first = static_cast<int>(i);
      }
    }
    std::vector<int> found;
    if (first < 0) return found;
    std::vector<bool> seen(body_.points.size(), false);
    found.push_back(first);
    seen[first] = true;
    for (std::size_t k = 0; k < found.size(); ++k) {
      for (const int next : neighbours_[found[k]]) {
        if (seen[next] || !holds(body_.points[next])) continue;
        seen[next] = true;
        found.push_back(next);
      }
    }
    return found;
  }

  /// Metres: the mean distance of a limb's skin from `at`, square to the unit vector `along`.
  double radius(const std::vector<int>& limb, const Vec3& at, const Vec3& along) const {
    double sum = 0;
    int count = 0;
    for (const int i : limb) {
      const Vec3 away = body_.points[i] - at;
      const double down = away.dot(along);
      if (std::abs(down) > 0.015 * scale_) continue;
      sum += (away - down * along).norm();
      ++count;
    }
    return count > 0 ? sum / count : 0.05 * scale_;
  }

  FootShape foot_shape(const std::vector<int>& leg, const Vec3& ankle) const {
    FootShape foot_found;
    Vec3 forward = Vec3::Zero();
    for (const int i : leg) {
      const Vec3& p = body_.points[i];
      if (p.y() < ankle.y() && p.z() > ankle.z() + 0.08 * scale_) forward += p - ankle;
    }
    forward.y() = 0;
    if (forward.norm() > 0) foot_found.along = forward.normalized();
    double heel = 0;
    double tip = 0;
    for (const int i : leg) {
      const Vec3& p = body_.points[i];
      if (p.y() > ankle.y()) continue;
      heel = std::min(heel, foot_found.along.dot(p - ankle));
      tip = std::max(tip, foot_found.along.dot(p - ankle));
    }
    foot_found.ball = ankle + (heel + ball_share * (tip - heel)) * foot_found.along;
    foot_found.ball.y() = 0;
    return foot_found;
  }

  void find_leg(bool left) {
    const Vec3& knee = joint(left, "knee");
    const Vec3& ankle = joint(left, "ankle");
    const double crotch = skeleton_.joint("pelvis").y();
    const double side = left ? 1 : -1;
    const double middle = skeleton_.joint("pelvis").x();
    const auto is_across = [&](int i) {
      return side * (body_.points[i].x() - middle) < -0.05 * scale_;
    };
    // A coarse mesh joins the legs by single edges below the crotch.
    std::vector<int> leg;
    bool joined = true;
    for (double below = crotch_margin; joined && below < below_crotch; below += 0.005) {
      const double top = crotch - below * scale_;
      leg = connected(knee, [top](const Vec3& p) { return p.y() < top; });
      joined = std::any_of(leg.begin(), leg.end(), is_across);
    }
    if (leg.empty() || joined) fail(left, "leg");

    const FootShape foot = foot_shape(leg, ankle);
    cores_.feet[left ? 0 : 1] = foot;
    const double ball = foot.along.dot(foot.ball - ankle);
    const Vec3 down =
        ((knee - joint(left, "hip")).normalized() + (ankle - knee).normalized()).normalized();
    const double reach = knee_reach * radius(leg, knee, down);
    for (const int i : leg) {
      on_limb_[i] = true;
      const Vec3& p = body_.points[i];
      const double before = foot.along.dot(p - ankle);
      const double past_knee = down.dot(p - knee);
      const bool low = p.y() < ankle.y() + above_ankle * scale_;
      int& core = cores_.bone_of[i];
      if (low && before > ball + ball_reach * scale_) {
        core = bone_index(Bone::toes, left);
      } else if (p.y() < ankle.y() - below_ankle * scale_ ||
                 (low && before > before_ankle * scale_)) {
        if (before < ball - ball_reach * scale_) core = bone_index(Bone::foot, left);
      } else if (!low && past_knee > reach) {
        core = bone_index(Bone::shin, left);
      } else if (past_knee < -reach && p.y() < crotch - below_crotch * scale_) {
        core = bone_index(Bone::thigh, left);
      }
    }
  }

  void find_arm(bool left) {
    const Vec3& shoulder = joint(left, "shoulder");
    const Vec3& elbow = joint(left, "elbow");
    const Vec3& wrist = joint(left, "wrist");
    const Vec3 down = (elbow - shoulder).normalized();
    const double length = (elbow - shoulder).norm();
    const double side = left ? 1 : -1;
    const double middle = skeleton_.joint("pelvis").x();
    const double inner = side * (shoulder.x() - middle) / 2;
    // The arm ends where what hangs together with the hand reaches into the trunk.
    std::vector<int> arm;
    double armpit = 0;
    for (double from = 0.9 * length; from > 0; from -= 0.004 * scale_) {
      std::vector<int> found =
          connected(wrist, [&](const Vec3& p) { return down.dot(p - shoulder) > from; });
      const bool joined = std::any_of(found.begin(), found.end(), [&](int i) {
        return side * (body_.points[i].x() - middle) < inner;
      });
      if (joined) break;
      arm = std::move(found);
      armpit = from;
    }
    if (arm.empty()) fail(left, "arm");

    const Vec3 mean = (down + (wrist - elbow).normalized()).normalized();
    const double reach = elbow_reach * radius(arm, elbow, mean);
    const double end = std::max(armpit + below_armpit * scale_, arm_end * scale_);
    for (const int i : arm) {
      on_limb_[i] = true;
      const Vec3& p = body_.points[i];
      const double past_elbow = mean.dot(p - elbow);
      if (past_elbow > reach) {
        cores_.bone_of[i] = bone_index(Bone::forearm, left);
      } else if (past_elbow < -reach && down.dot(p - shoulder) > end) {
        cores_.bone_of[i] = bone_index(Bone::upper_arm, left);
      }
    }
  }

  void find_trunk() {
    const double crotch = skeleton_.joint("pelvis").y();
    const double middle = skeleton_.joint("pelvis").x();
    const double hips =
        std::max(joint(true, "hip").y(), joint(false, "hip").y()) + above_hip * scale_;
    const double sides = skeleton_.joint("chest").y() - side_length * scale_;
    const double neck = skeleton_.joint("neck").y();
    for (std::size_t i = 0; i < body_.points.size(); ++i) {
      if (on_limb_[i]) continue;
      const Vec3& p = body_.points[i];
      const double off = std::abs(p.x() - middle);
      bool stays = false;
      if (p.y() < hips) {
        stays = off < middle_strip * scale_ && p.y() > crotch - 0.03 * scale_;
      } else {
        const double shoulder = std::abs(joint(p.x() > middle, "shoulder").x() - middle);
        stays = p.y() < sides || p.y() > neck || off < shoulder - shoulder_width * scale_;
      }
      if (stays) cores_.bone_of[i] = bone_index(Bone::trunk, true);
    }
  }

  const TriangleMesh& body_;
  const Skeleton& skeleton_;
  const std::string& name_;
  double scale_;
  std::vector<bool> on_limb_;
  Adjacency<int> neighbours_;
  SkinCores cores_;
};

}  // namespace

SkinCores skin_cores(const TriangleMesh& body, const Skeleton& skeleton, const std::string& name) {
  return SkinCoreFinder(body, skeleton, name).find();
}

}  // namespace toile
