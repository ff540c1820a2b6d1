#include "geometry/body/body_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/body/find_skeleton.h"
#include "geometry/body/torso_section.h"
#include "geometry/error.h"

namespace toile {

namespace {

Eigen::Matrix3d about_y(double angle) {
  return Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
}

/// Radians of the turn about y that brings the direction to +x.
double turn_to_x(const Vec3& across) { return std::atan2(across.z(), across.x()); }

/// Second moments of level offsets, and their widest direction.
struct LevelMoments {
  double xx = 0;
  double xz = 0;
  double zz = 0;

  void add(double weight, const Vec3& d) {
    xx += weight * d.x() * d.x();
    xz += weight * d.x() * d.z();
    zz += weight * d.z() * d.z();
  }
  /// Radians from the x axis toward z, within a quarter turn.
  double widest() const { return std::atan2(2 * xz, xx - zz) / 2; }
};

/// The area-weighted middle of the surface. `turn` is the radians of the turn that brings its
/// widest level direction to the x axis, within a quarter turn.
struct Spread {
  Vec3 middle = Vec3::Zero();
  double turn = 0;
};

Spread spread_of(const TriangleMesh& mesh) {
  Spread spread;
  double area = 0;
  const auto each = [&mesh](const auto& take) {
    for (const Triangle& t : mesh.triangles) {
      const Vec3& a = mesh.points[t[0]];
      const Vec3& b = mesh.points[t[1]];
      const Vec3& c = mesh.points[t[2]];
      take((b - a).cross(c - a).norm() / 2, Vec3((a + b + c) / 3));
    }
  };
  each([&](double part, const Vec3& at) {
    area += part;
    spread.middle += part * at;
  });
  if (area > 0) spread.middle /= area;
  LevelMoments moments;
  each([&](double part, const Vec3& at) { moments.add(part, at - spread.middle); });
  spread.turn = moments.widest();
  return spread;
}

/// Turns the frame, whose skeleton is looked for anew. With `in_part`, an arm or the head may be
/// missing.
void turn_frame(BodyFrame& frame, double angle, const std::string& name, bool in_part = false) {
  const Eigen::Matrix3d rotation = about_y(angle);
  for (Vec3& p : frame.mesh.points) p = rotation * p;
  frame.rotation = rotation * frame.rotation;
  frame.translation = rotation * frame.translation;
  frame.skeleton.reset();
  frame.missing.clear();
  try {
    if (in_part) {
      ShownJoints shown = shown_joints(frame.mesh, name);
      frame.skeleton = std::move(shown.skeleton);
      frame.missing = std::move(shown.missing);
    } else {
      frame.skeleton = find_skeleton(frame.mesh, name);
    }
    frame.no_skeleton.clear();
  } catch (const Error& error) {
    if (frame.no_skeleton.empty()) frame.no_skeleton = error.what();
  }
}

Vec3 between(const Skeleton& skeleton, const std::string& joint) {
  return (skeleton.joint("left_" + joint) + skeleton.joint("right_" + joint)) / 2;
}

Vec3 across(const Skeleton& skeleton, const std::string& joint) {
  return (skeleton.joint("left_" + joint) - skeleton.joint("right_" + joint)).normalized();
}

bool has_both_shoulders(const Skeleton& skeleton) {
  return skeleton.joints.contains("left_shoulder") && skeleton.joints.contains("right_shoulder");
}

/// The widest level direction of the trunk from crotch to armpits. One arm alone says nothing.
Vec3 across_trunk(const BodyFrame& frame) {
  const double low = frame.skeleton->joint("pelvis").y();
  const double high = frame.skeleton->joint("chest").y();
  LevelMoments moments;
  constexpr int levels = 12;
  for (int level = 1; level < levels; ++level) {
    const auto section = torso_section(frame.mesh, low + level * (high - low) / levels);
    if (!section) continue;
    const std::vector<Vec3>& points = section->points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& next = points[(i + 1) % points.size()];
      const Vec3 d = (points[i] + next) / 2 - section->centroid;
      moments.add((next - points[i]).norm(), d);
    }
  }
  const double angle = moments.widest();
  return {std::cos(angle), 0, std::sin(angle)};
}

void move(BodyFrame& frame, const Vec3& by) {
  for (Vec3& p : frame.mesh.points) p += by;
  frame.translation += by;
  if (!frame.skeleton) return;
  for (auto& [name, joint] : frame.skeleton->joints) joint += by;
}

}  // namespace

BodyFrame body_frame(const TriangleMesh& body, const std::string& name) {
  return body_frame(body, body, name);
}

BodyFrame body_frame(const TriangleMesh& body, const TriangleMesh& smooth,
                     const std::string& name) {
  if (body.triangles.empty()) throw Error(name, "has no surface", "give a closed body");
  BodyFrame frame;
  frame.mesh = smooth;
  const Spread spread = spread_of(smooth);
  double low = body.points[body.triangles.front()[0]].y();
  double high = low;
  for (const Vec3& p : body.points) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  frame.height = high - low;
  move(frame, -Vec3(spread.middle.x(), low, spread.middle.z()));

  // Arms that reach forward may make a body deeper than wide.
  turn_frame(frame, spread.turn, name);
  if (!frame.skeleton) {
    turn_frame(frame, std::numbers::pi / 2, name);
    if (!frame.skeleton) turn_frame(frame, -std::numbers::pi / 2, name);
  }
  const bool in_part = !frame.skeleton;
  for (const double angle : {0.0, std::numbers::pi / 2, -std::numbers::pi / 2}) {
    if (!frame.skeleton) turn_frame(frame, angle, name, true);
  }
  if (!frame.skeleton) return frame;
  // What is found askew is less true: once more, in the frame that it gives.
  const Vec3 level =
      has_both_shoulders(*frame.skeleton)
          ? Vec3(across(*frame.skeleton, "shoulder") + across(*frame.skeleton, "hip"))
          : across_trunk(frame);
  const bool backward = toes_forward(frame.mesh, *frame.skeleton) < -0.01;
  const BodyFrame before = frame;
  turn_frame(frame, turn_to_x(level) + (backward ? std::numbers::pi : 0), name, in_part);
  if (!frame.skeleton) frame = before;
  Vec3 middle = between(*frame.skeleton, "hip");
  if (has_both_shoulders(*frame.skeleton)) {
    middle = (middle + between(*frame.skeleton, "shoulder")) / 2;
  }
  move(frame, Vec3(-middle.x(), 0, 0));
  return frame;
}

}  // namespace toile
