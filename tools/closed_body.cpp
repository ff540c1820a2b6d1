#include "tools/closed_body.h"

#include <algorithm>

#include "geometry/closed_surface.h"
#include "geometry/error.h"
#include "io/mesh_file.h"

namespace toile {

namespace {

/// Metres; from a child's torso to a giant.
constexpr double least_height = 0.1;
constexpr double most_height = 3;

}  // namespace

TriangleMesh read_closed_body(const std::filesystem::path& path) {
  TriangleMesh body = fan_triangles(read_mesh(path));
  const std::string defect = closed_surface_defect(body);
  if (!defect.empty()) {
    throw Error(path.string(), "the body " + defect + ", so inside and outside can't be told",
                "run clean-body on it");
  }
  double low = body.points.front().y();
  double high = low;
  for (const Vec3& p : body.points) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  if (!(high - low > least_height && high - low < most_height)) {
    throw Error(path.string(), "the body is " + std::to_string(high - low) + " m tall",
                "let clean-body bring it to metres, with --unit if need be");
  }
  return body;
}

}  // namespace toile
