#include "geometry/scan/floor_slope.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/scan/scan_cells.h"

namespace toile {

namespace {

// Half or double of any up to `trials` was tried on floors that slope by 0, 3, 10 and 20 degrees.
// Their slopes are the same to 0.1 degrees. Heights of the two bodies move by 0.2 mm at most.
//
// Shares of the scan's longest side.
constexpr double cell_size = 1.0 / 90;
constexpr double on_plane = 1.0 / 200;  // 9 mm of an adult
constexpr double least_spread = 0.15;   // of three points that tell a plane
/// A floor has this share of the square of the longest side, as in sort_scan().
constexpr double least_area = 0.03;
/// Share of the cells that may be below: outliers.
constexpr double below_share = 0.04;
/// Of three random cells, all are a floor's of a fifth of the cells in 1 of 125 trials.
constexpr int trials = 2000;
constexpr double level_degrees = 0.5;
constexpr double most_degrees = 40;

struct LevelPlane {
  Vec3 normal = Vec3::Zero();  // up
  double level = 0;
};

struct Count {
  int on = 0;
  int above = 0;
  int below = 0;
};

Count count(const std::vector<Vec3>& places, const LevelPlane& plane, double near) {
  Count found;
  for (const Vec3& p : places) {
    const double off = plane.normal.dot(p) - plane.level;
    if (std::abs(off) <= near) {
      ++found.on;
    } else if (off > 0) {
      ++found.above;
    } else {
      ++found.below;
    }
  }
  return found;
}

/// The plane of least squares through the places near to a plane.
LevelPlane fitted(const std::vector<Vec3>& places, const LevelPlane& plane, double near) {
  Vec3 mean = Vec3::Zero();
  int n = 0;
  for (const Vec3& p : places) {
    if (std::abs(plane.normal.dot(p) - plane.level) > near) continue;
    mean += p;
    ++n;
  }
  mean /= n;
  Eigen::Matrix3d spread_of = Eigen::Matrix3d::Zero();
  for (const Vec3& p : places) {
    if (std::abs(plane.normal.dot(p) - plane.level) > near) continue;
    spread_of += (p - mean) * (p - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread_of);
  Vec3 normal = axes.eigenvectors().col(0).normalized();
  if (normal.dot(plane.normal) < 0) normal = -normal;
  return {normal, normal.dot(mean)};
}

}  // namespace

std::optional<FloorSlope> floor_slope(const std::vector<Vec3>& points,
                                      const std::optional<AxisDirection>& up) {
  if (points.size() < 100) return std::nullopt;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(p);
  const double longest = box.sizes().maxCoeff();
  if (!(longest > 0)) return std::nullopt;
  const ScanCells cells(points, cell_size * longest);
  const std::vector<Vec3>& places = cells.means();
  const double near = on_plane * longest;
  const double most_below = below_share * static_cast<double>(places.size());
  std::mt19937_64 random(1);
  LevelPlane best;
  int most = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Vec3& a = places[random() % places.size()];
    const Vec3& b = places[random() % places.size()];
    const Vec3& c = places[random() % places.size()];
    const Vec3 across = (b - a).cross(c - a);
    if (across.norm() < std::pow(least_spread * longest, 2)) continue;
    LevelPlane plane{across.normalized(), 0};
    plane.level = plane.normal.dot(a);
    Count found = count(places, plane, near);
    if (found.below > found.above) {
      plane = {-plane.normal, -plane.level};
      std::swap(found.below, found.above);
    }
    if (found.on <= most || found.below > most_below) continue;
    most = found.on;
    best = plane;
  }
  const double tile = cells.size() * cells.size();
  if (most * tile < least_area * longest * longest) return std::nullopt;
  for (int round = 0; round < 3; ++round) best = fitted(places, best, near);
  if (count(places, best, near).below > most_below) return std::nullopt;
  int axis = 0;
  best.normal.cwiseAbs().maxCoeff(&axis);
  FloorSlope slope;
  slope.up = {axis, best.normal[axis] > 0 ? 1 : -1};
  if (up && (up->axis != slope.up.axis || up->sign != slope.up.sign)) return std::nullopt;
  const double cosine = std::min(1.0, best.normal.dot(slope.up.vector()));
  slope.degrees = std::acos(cosine) * 180 / std::numbers::pi;
  if (slope.degrees < level_degrees || slope.degrees > most_degrees) return std::nullopt;
  slope.turn =
      Eigen::Quaterniond::FromTwoVectors(best.normal, slope.up.vector()).toRotationMatrix();
  return slope;
}

}  // namespace toile
