#include "tools/closed_body.h"

#include "geometry/closed_surface.h"
#include "geometry/error.h"
#include "io/mesh_file.h"

namespace toile {

TriangleMesh read_closed_body(const std::filesystem::path& path) {
  TriangleMesh body = fan_triangles(read_mesh(path));
  const std::string defect = closed_surface_defect(body);
  if (!defect.empty()) {
    throw Error(path.string(), "the body " + defect + ", so inside and outside can't be told",
                "run clean-body on it");
  }
  return body;
}

}  // namespace toile
