// A model of a body scanner: what cameras on columns around a body measure of it.
#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/body/find_landmarks.h"
#include "geometry/scan/point_cloud.h"
#include "geometry/scan/scan_cells.h"
#include "geometry/surface_distance.h"

namespace toile::test {

struct Scanner {
  int points = 50000;      ///< about, floor and all
  double noise = 0.001;    ///< metres: standard deviation along the ray
  double outliers = 0.01;  ///< share of the points that are anywhere in the box
  int columns = 6;         ///< with cameras at three heights each, 1.8 m from the middle
  bool floor = true;       ///< a disc of 0.5 m around the feet is seen, too
  bool gaps = true;        ///< nothing is measured within 5 cm of armpits, crotch and crown
  unsigned seed = 1;
};

struct Scan {
  PointCloud cloud;         ///< metres, in the body's frame
  std::vector<Vec3> truth;  ///< where rays met the body, without noise
};

/// Rays at a body.
class Rays {
 public:
  explicit Rays(const TriangleMesh& body) : device_(rtcNewDevice(nullptr)) {
    scene_ = rtcNewScene(device_);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const points = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), body.points.size()));
    for (std::size_t i = 0; i < body.points.size(); ++i) {
      for (int k = 0; k < 3; ++k) points[3 * i + k] = static_cast<float>(body.points[i][k]);
    }
    auto* const corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), body.triangles.size()));
    for (std::size_t i = 0; i < body.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) corners[3 * i + k] = static_cast<unsigned>(body.triangles[i][k]);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~Rays() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Rays(const Rays&) = delete;
  Rays& operator=(const Rays&) = delete;

  struct Hit {
    double distance = 0;  ///< infinite: nothing is met
    Vec3 normal;
  };
  Hit meet(const Vec3& from, const Vec3& direction) const {
    RTCRayHit ray = {};
    ray.ray.org_x = static_cast<float>(from.x());
    ray.ray.org_y = static_cast<float>(from.y());
    ray.ray.org_z = static_cast<float>(from.z());
    ray.ray.dir_x = static_cast<float>(direction.x());
    ray.ray.dir_y = static_cast<float>(direction.y());
    ray.ray.dir_z = static_cast<float>(direction.z());
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
    return {ray.ray.tfar, Vec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z).normalized()};
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

/// Scans a body in metres that stands on y = 0. Cameras don't see skin that is turned away from
/// them by more than 80 degrees, nor what something else hides.
inline Scan scan_body(const TriangleMesh& body, const Scanner& scanner) {
  const Rays rays(body);
  Eigen::AlignedBox3d box;
  for (const Vec3& p : body.points) box.extend(p);
  const double tall = box.max().y();
  std::vector<Vec3> gaps;
  if (scanner.gaps) {
    const Landmarks marks = given_landmarks(find_landmarks(body, "body"));
    for (const char* name : {"left_armpit", "right_armpit", "crotch", "crown"}) {
      if (const auto place = place_of(marks, name)) gaps.push_back(*place);
    }
  }
  std::mt19937_64 bits(scanner.seed);
  const auto share = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  const auto normal = [&share] {  // Box & Muller 1958
    return std::sqrt(-2 * std::log(1 - share())) * std::cos(2 * std::numbers::pi * share());
  };
  std::vector<Vec3> cameras;
  for (int column = 0; column < scanner.columns; ++column) {
    const double angle = 2 * std::numbers::pi * (column + 0.5) / scanner.columns;
    for (const double height : {0.25, 0.65, 1.1}) {
      cameras.emplace_back(1.8 * std::sin(angle), height * tall, 1.8 * std::cos(angle));
    }
  }
  // Each camera draws its rays at random over the body's silhouette from its side.
  const double wide = box.sizes().norm() - tall / 2;
  Scan scan;
  const std::size_t outliers = static_cast<std::size_t>(scanner.outliers * scanner.points);
  const std::size_t wanted = static_cast<std::size_t>(scanner.points) - outliers;
  for (std::size_t ray = 0; scan.cloud.points.size() < wanted; ++ray) {
    const Vec3& from = cameras[ray % cameras.size()];
    const Vec3 side = Vec3::UnitY().cross(from).normalized();
    const Vec3 to = Vec3(0, (share() * 1.1 - 0.08) * tall, 0) + (share() - 0.5) * wide * side;
    const Vec3 direction = (to - from).normalized();
    const Rays::Hit hit = rays.meet(from, direction);
    const double down = direction.y() < 0 ? -from.y() / direction.y() : HUGE_VAL;
    const double distance = std::min(hit.distance, down);
    if (!std::isfinite(distance)) continue;
    const Vec3 at = from + distance * direction;
    if (down < hit.distance) {
      if (!scanner.floor || at.norm() > 0.5) continue;
    } else {
      if (std::abs(hit.normal.dot(direction)) < std::cos(80 * std::numbers::pi / 180)) continue;
      const bool is_gap = std::any_of(gaps.begin(), gaps.end(),
                                      [&](const Vec3& gap) { return (at - gap).norm() < 0.05; });
      if (is_gap) continue;
      scan.truth.push_back(at);
    }
    scan.cloud.points.push_back(at + scanner.noise * normal() * direction);
  }
  const Vec3 room = box.sizes() + Vec3(0.4, 0.2, 0.4);
  for (std::size_t i = 0; i < outliers; ++i) {
    scan.cloud.points.push_back(
        box.center() + Vec3(share() - 0.5, share() - 0.5, share() - 0.5).cwiseProduct(room));
  }
  return scan;
}

/// How near a reconstructed surface is to the truth: shares of area, each the lesser one of both
/// surfaces' to the other. Inner surfaces, such as a mouth's, are left out: no ray leaves them.
struct Agreement {
  double seen_2mm = 1;
  double seen_5mm = 1;
  double unseen_10mm = 1;
  double unseen = 0;        ///< share of the true surface that no ray met within `reach`
  double seen_worst = 0;    ///< metres
  double unseen_worst = 0;  ///< metres
};

/// Points spread evenly over a surface.
inline std::vector<Vec3> spread_points(const TriangleMesh& mesh, int count) {
  std::vector<double> sums;
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.points[t[0]];
    sum += (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).norm() / 2;
    sums.push_back(sum);
  }
  std::mt19937_64 bits(7);
  const auto share = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const auto at = std::lower_bound(sums.begin(), sums.end(), (i + share()) / count * sum);
    const Triangle& t = mesh.triangles[std::min(at, sums.end() - 1) - sums.begin()];
    const double u = std::sqrt(share());
    const double v = share();
    points.push_back((1 - u) * mesh.points[t[0]] + u * (1 - v) * mesh.points[t[1]] +
                     u * v * mesh.points[t[2]]);
  }
  return points;
}

inline Agreement agreement(const TriangleMesh& surface, const TriangleMesh& truth, const Scan& scan,
                           double reach, int count = 40000) {
  const ScanCells cells(scan.truth, reach);
  std::vector<std::vector<int>> in_cell(cells.cells());
  for (std::size_t i = 0; i < scan.truth.size(); ++i) {
    in_cell[cells.cell_of()[i]].push_back(static_cast<int>(i));
  }
  const auto is_seen = [&](const Vec3& p) {
    bool seen = false;
    cells.near(p, 1, [&](int cell) {
      for (const int i : in_cell[cell]) seen = seen || (scan.truth[i] - p).norm() < reach;
    });
    return seen;
  };
  const Rays rays(truth);
  const auto is_inner = [&](const Vec3& p, const Vec3& normal) {
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          const Vec3 direction(x, y, z);
          if (direction.dot(normal) <= 0) continue;
          if (!std::isfinite(rays.meet(p + 1e-4 * normal, direction.normalized()).distance)) {
            return false;
          }
        }
      }
    }
    return true;
  };
  Agreement result;
  const auto judge = [&](const TriangleMesh& from, const TriangleMesh& to, bool from_truth) {
    const SurfaceDistance distance(to);
    const SurfaceDistance own(from);
    int seen = 0, near2 = 0, near5 = 0, unseen = 0, near10 = 0;
    for (const Vec3& p : spread_points(from, count)) {
      const SurfacePoint other = distance.closest_point(p);
      const double off = std::abs(other.distance);
      if (is_seen(from_truth ? p : other.point)) {
        ++seen;
        near2 += off <= 0.002;
        near5 += off <= 0.005;
        result.seen_worst = std::max(result.seen_worst, off);
      } else {
        if (from_truth && is_inner(p, own.closest_point(p).normal)) continue;
        ++unseen;
        near10 += off <= 0.01;
        result.unseen_worst = std::max(result.unseen_worst, off);
      }
    }
    result.seen_2mm = std::min(result.seen_2mm, static_cast<double>(near2) / std::max(1, seen));
    result.seen_5mm = std::min(result.seen_5mm, static_cast<double>(near5) / std::max(1, seen));
    if (unseen > 0) {
      result.unseen_10mm = std::min(result.unseen_10mm, static_cast<double>(near10) / unseen);
    }
    if (from_truth) result.unseen = static_cast<double>(unseen) / count;
  };
  judge(truth, surface, true);
  judge(surface, truth, false);
  return result;
}

}  // namespace toile::test
