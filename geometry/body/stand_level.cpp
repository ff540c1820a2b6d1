#include "geometry/body/stand_level.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angles.h"

namespace toile {

namespace {

// At half or double of it, bodies that lean are turned by 0.3 or 0.6 degrees more or less.
constexpr double forward_lean = 0.6 * radians_per_degree;
// Between the legs, seen from the side. At half or double, five bodies that lean by up to 15
// degrees and one that walks are turned as before.
constexpr double most_step = 10 * radians_per_degree;
// Share of the height, above the floor, that holds all of the soles. At half or double, the same
// six bodies are turned as before.
constexpr double soles = 0.03;
// Cosine between the plumb line and the normal of a surface that counts as sole. At half of it,
// the same six bodies are turned as before; double is beyond 1, and none would be turned.
constexpr double least_facing = 0.8;

/// Square metres: how unlevel the soles are, as the variance of their heights along `up`.
double unevenness(const TriangleMesh& body, const Vec3& up, double height) {
  double floor = std::numeric_limits<double>::infinity();
  for (const Vec3& p : body.points) floor = std::min(floor, up.dot(p));
  double area = 0;
  double sum = 0;
  double squares = 0;
  for (const Triangle& t : body.triangles) {
    const Vec3& a = body.points[t[0]];
    const Vec3& b = body.points[t[1]];
    const Vec3& c = body.points[t[2]];
    const double high = up.dot(a + b + c) / 3 - floor;
    if (high > soles * height) continue;
    const Vec3 normal = (b - a).cross(c - a) / 2;
    const double part = normal.norm();
    if (-up.dot(normal) < least_facing * part) continue;
    area += part;
    sum += part * high;
    squares += part * high * high;
  }
  return area > 0 ? squares / area - (sum / area) * (sum / area) : 0;
}

}  // namespace

std::optional<Eigen::Matrix3d> turn_upright(const Skeleton& skeleton, double least_lean) {
  const auto leg = [&skeleton](const std::string& side) {
    return Vec3(skeleton.joint(side + "hip") - skeleton.joint(side + "ankle"));
  };
  const auto sagittal = [](const Vec3& v) { return std::atan2(v.z(), v.y()); };
  if (std::abs(sagittal(leg("left_")) - sagittal(leg("right_"))) > most_step) return std::nullopt;
  const Vec3 ankles = (skeleton.joint("left_ankle") + skeleton.joint("right_ankle")) / 2;
  const Vec3 line = (skeleton.joint("neck") - ankles).normalized();
  const Vec3 wanted(0, std::cos(forward_lean), std::sin(forward_lean));
  if (std::acos(std::clamp(line.dot(wanted), -1.0, 1.0)) < least_lean) return std::nullopt;
  return Eigen::Quaterniond::FromTwoVectors(line, wanted).toRotationMatrix();
}

bool levels_soles(const Eigen::Matrix3d& turn, const TriangleMesh& body) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec3& p : body.points) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  const Vec3 up = turn.transpose() * Vec3::UnitY();
  return unevenness(body, up, high - low) < unevenness(body, Vec3::UnitY(), high - low);
}

}  // namespace toile
