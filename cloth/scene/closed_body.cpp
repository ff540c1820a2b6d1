#include "cloth/scene/closed_body.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "geometry/body/clean_body.h"
#include "geometry/closed_surface.h"
#include "geometry/error.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"

namespace toile {

namespace {

/// Metres: heights from a child's torso to a giant.
constexpr double min_height = 0.1;
constexpr double max_height = 3;
/// Metres from the origin to the body. Garments are placed around the origin.
constexpr double max_away = 10;

Eigen::AlignedBox3d bounds_of(const TriangleMesh& body) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : body.points) box.extend(p);
  return box;
}

/// Removes points that belong to no triangle. They may be anywhere and are no part of the body.
void remove_loose_points(TriangleMesh& body) {
  std::vector<int> now(body.points.size(), -1);
  for (const Triangle& triangle : body.triangles) {
    for (const int p : triangle) now[p] = 0;
  }
  int kept = 0;
  for (std::size_t p = 0; p < now.size(); ++p) {
    if (now[p] < 0) continue;
    body.points[kept] = body.points[p];
    now[p] = kept++;
  }
  body.points.resize(kept);
  for (Triangle& triangle : body.triangles) {
    for (int& p : triangle) p = now[p];
  }
}

}  // namespace

TriangleMesh read_closed_body(const std::filesystem::path& path) {
  return closed_body(fan_triangles(read_mesh(path)), path.string());
}

TriangleMesh closed_body(TriangleMesh body, const std::string& name) {
  const std::string defect = closed_surface_defect(body);
  if (!defect.empty()) {
    throw Error(name, "the body " + defect + ", so inside and outside can't be told",
                "run clean-body on it");
  }
  remove_loose_points(body);
  const Eigen::AlignedBox3d bounds = bounds_of(body);
  const double height = bounds.sizes().y();
  if (!(height > min_height && height < max_height)) {
    throw Error(name, "the body is " + number_text(height) + " m tall",
                "let clean-body bring it to metres, with --unit if need be");
  }
  const double wide = std::max(bounds.sizes().x(), bounds.sizes().z());
  if (!(wide < max_height)) {
    throw Error(name, "the body is " + number_text(wide) + " m wide",
                "remove what does not belong to it, and let clean-body bring it to metres");
  }
  const double away = bounds.exteriorDistance(Vec3(0, 0, 0));
  if (!(away < max_away)) {
    throw Error(name,
                "the body stands " + std::to_string(std::lround(away)) +
                    " m from the origin, which garments are placed around",
                "let clean-body bring it there");
  }
  return body;
}

Skeleton read_skeleton_of(const SurfaceDistance& body, const std::filesystem::path& path) {
  return skeleton_of(body, read_skeleton(path), path.string());
}

Skeleton skeleton_of(const SurfaceDistance& body, Skeleton skeleton, const std::string& name) {
  if (const auto outside = joint_outside(skeleton, body)) {
    constexpr double far = 10;
    throw Error(name,
                "joint '" + outside->name + "' lies " +
                    (outside->by < far ? centimetres(outside->by, 1) : "far") +
                    " outside of the body",
                "they are another body's joints: write this one's with clean-body");
  }
  return skeleton;
}

}  // namespace toile
