#include "geometry/body/raise_arms.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/angles.h"

namespace toile {

namespace {

/// Radians by which an arm has to be raised to be raised at all.
constexpr double min_turn = 15 * radians_per_degree;
/// Radians to either side of the arm's middle that turn with it as one.
constexpr double half_width = 20 * radians_per_degree;
/// Radians below the arm's middle at which space stays, far from the shoulder.
constexpr double far_room = 27 * radians_per_degree;
/// Radians above and below the horizontal from which on space stays near the shoulder.
constexpr double trunk_angle = 100 * radians_per_degree;
/// Metres from the shoulder at which the armpit begins and ends.
constexpr double armpit_from = 0.06;
constexpr double armpit_to = 0.20;
/// Share of its radius to which an arm is slimmed, from the one distance to the other (metres) down
/// the arm.
constexpr double slim_share = 0.5;
constexpr double slim_from = 0.06;
constexpr double slim_to = 0.16;
/// Metres that an arm has to leave the plane of its shoulder to be brought into it. Arms of two
/// average bodies leave it by 0.065, MakeHuman's by 0.15: at half of it both would be, at double
/// neither.
constexpr double min_depth = 0.08;
/// Radians to either side of the arm's middle up to which space is shifted with it in full, and
/// from which on it stays.
constexpr double full_shift = 14 * radians_per_degree;
constexpr double no_shift = 27 * radians_per_degree;
/// Metres beyond the wrist that a hand reaches.
constexpr double hand_reach = 0.2;
/// Metres before and behind the arm up to which space turns with it in full, and from which on it
/// stays.
constexpr double full_depth = 0.10;
constexpr double no_depth = 0.30;

double blend(double x, double from, double to) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The piecewise linear map of angles that takes `from[i]` to `to[i]`, both rising; others stay.
double mapped(double angle, const std::array<double, 4>& from, const std::array<double, 4>& to) {
  if (angle <= from.front() || angle >= from.back()) return angle;
  for (std::size_t i = 0; i + 1 < from.size(); ++i) {
    if (angle > from[i + 1]) continue;
    return to[i] + (angle - from[i]) / (from[i + 1] - from[i]) * (to[i + 1] - to[i]);
  }
  return angle;
}

}  // namespace

ArmRaise::ArmRaise(const Skeleton& skeleton, const TriangleMesh& body, double raised_angle) {
  for (const std::string side : {"left", "right"}) {
    const auto at = [&](const std::string& joint) { return skeleton.joints.find(side + joint); };
    const auto none = skeleton.joints.end();
    if (at("_shoulder") == none || at("_elbow") == none || at("_wrist") == none) continue;
    Arm arm;
    arm.part = arm_of(side == "left");
    arm.joints = {at("_shoulder")->second, at("_elbow")->second, at("_wrist")->second};
    arm.shoulder = arm.joints[0];
    arm.side = side == "left" ? 1 : -1;
    const Vec3 down = arm.joints[2] - arm.joints[0];
    arm.angle = std::atan2(down.y(), arm.side * down.x());
    arm.turn = raised_angle - arm.angle;
    if (arm.turn < min_turn || arm.angle < -trunk_angle + far_room) continue;
    for (const Vec3& joint : arm.joints) {
      if (std::abs(joint.z() - arm.shoulder.z()) > min_depth) arm.leaves_plane = true;
    }
    arms_.push_back(std::move(arm));
    Arm& made = arms_.back();
    made.axis = turned_with(made.part, made.joints[2]) - made.shoulder;
    if (made.leaves_plane) made.axis.z() = 0;
    made.axis.normalize();
    for (const Vec3& p : body.points) {
      if (made.side * (p.x() - made.shoulder.x()) < 0) continue;
      const Vec3 q = turned(made, p, false);
      if ((q - p).norm() < 0.05) continue;
      const Vec3 away = q - made.shoulder;
      const double along = away.dot(made.axis);
      const double radius = (away - along * made.axis).norm();
      if (along < slim_to || radius > 0.15) continue;
      made.radius = std::max(made.radius, radius);
    }
  }
}

/// Metres: the depth z of the arm's bones at a distance from the shoulder, in the plane.
double ArmRaise::depth_of(const Arm& arm, double radius) {
  double from = 0;
  for (std::size_t i = 0; i + 1 < arm.joints.size(); ++i) {
    const Vec3 a = arm.joints[i];
    const Vec3 b = arm.joints[i + 1];
    const double to = std::hypot(b.x() - arm.shoulder.x(), b.y() - arm.shoulder.y());
    if (radius < to || i + 2 == arm.joints.size()) {
      const double last = arm.leaves_plane && i + 2 == arm.joints.size() ? to + hand_reach : to;
      const double t = (std::clamp(radius, from, last) - from) / std::max(to - from, 1e-6);
      return a.z() + t * (b.z() - a.z());
    }
    from = to;
  }
  return arm.shoulder.z();
}

/// Metres along z by which space is shifted with an arm that leaves the plane of its shoulder.
/// `radius`: metres from the shoulder, in that plane. `angle`: radians, as the arm hangs.
double ArmRaise::shift(const Arm& arm, double radius, double angle) {
  if (!arm.leaves_plane) return 0;
  return (1 - blend(std::abs(angle - arm.angle), full_shift, no_shift)) *
         (depth_of(arm, radius) - arm.shoulder.z());
}

Vec3 ArmRaise::turned(const Arm& arm, const Vec3& p, bool back) {
  const double across = arm.side * (p.x() - arm.shoulder.x());
  const double up = p.y() - arm.shoulder.y();
  const double radius = std::hypot(across, up);
  const double z = back ? p.z() : p.z() - shift(arm, radius, std::atan2(up, across));
  const double middle = arm.leaves_plane ? arm.shoulder.z() : depth_of(arm, radius);
  const double turn = arm.turn * (1 - blend(std::abs(z - middle), full_depth, no_depth));
  if (radius == 0 || (turn == 0 && !arm.leaves_plane)) return p;
  const double low = arm.angle - half_width;
  const double high = arm.angle + half_width;
  const double armpit = blend(radius, armpit_from, armpit_to);
  const double stays = -trunk_angle + armpit * (arm.angle - far_room + trunk_angle);
  const std::array<double, 4> hanging = {stays, low, high, trunk_angle};
  const std::array<double, 4> raised = {stays, low + turn, high + turn, trunk_angle};
  const double angle = std::atan2(up, across);
  const double to = back ? mapped(angle, raised, hanging) : mapped(angle, hanging, raised);
  return {arm.shoulder.x() + arm.side * radius * std::cos(to),
          arm.shoulder.y() + radius * std::sin(to), back ? z + shift(arm, radius, to) : z};
}

Vec3 ArmRaise::slimmed(const Arm& arm, const Vec3& p, bool back) {
  const Vec3 away = p - arm.shoulder;
  const double along = away.dot(arm.axis);
  const Vec3 out = away - along * arm.axis;
  const double radius = out.norm();
  const double outer = 2 * arm.radius;
  const double share = 1 + blend(along, slim_from, slim_to) * (slim_share - 1);
  if (share == 1 || radius == 0 || radius >= outer) return p;
  const double inner = back ? share * arm.radius : arm.radius;
  const double inner_to = back ? arm.radius : share * arm.radius;
  const double to = radius <= inner
                        ? radius * inner_to / inner
                        : inner_to + (radius - inner) / (outer - inner) * (outer - inner_to);
  return p + (to / radius - 1) * out;
}

Vec3 ArmRaise::raised(const Vec3& p) const {
  Vec3 q = p;
  for (const Arm& arm : arms_) q = slimmed(arm, turned(arm, q, false), false);
  return q;
}

Vec3 ArmRaise::lowered(const Vec3& p) const {
  Vec3 q = p;
  for (auto arm = arms_.rbegin(); arm != arms_.rend(); ++arm)
    q = turned(*arm, slimmed(*arm, q, true), true);
  return q;
}

Vec3 ArmRaise::turned_with(BodyPart part, const Vec3& p) const {
  for (const Arm& arm : arms_) {
    if (arm.part != part) continue;
    const double across = arm.side * (p.x() - arm.shoulder.x());
    const double up = p.y() - arm.shoulder.y();
    const double c = std::cos(arm.turn);
    const double s = std::sin(arm.turn);
    return {arm.shoulder.x() + arm.side * (c * across - s * up),
            arm.shoulder.y() + s * across + c * up, p.z()};
  }
  return p;
}

TriangleMesh ArmRaise::raised(TriangleMesh body) const {
  for (Vec3& p : body.points) p = raised(p);
  return body;
}

Skeleton ArmRaise::raised(Skeleton skeleton) const {
  for (const Arm& arm : arms_) {
    const std::string side = arm.side > 0 ? "left" : "right";
    for (const char* joint : {"_elbow", "_wrist"}) {
      Vec3& p = skeleton.joints.at(side + joint);
      p = turned_with(arm.part, p);
      if (arm.leaves_plane) p.z() = arm.shoulder.z();
    }
  }
  return skeleton;
}

}  // namespace toile
