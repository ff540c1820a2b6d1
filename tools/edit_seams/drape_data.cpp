#include "tools/edit_seams/drape_data.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/json_value.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "pattern/garment_file.h"
#include "tools/report.h"

namespace toile {

namespace {

using nlohmann::json;

/// To a hundredth of a millimetre, which no picture shows.
json points_json(const std::vector<Vec3>& points) {
  json flat = json::array();
  for (const Vec3& p : points) {
    for (int k = 0; k < 3; ++k) flat.push_back(std::round(1e5 * p[k]) / 1e5);
  }
  return flat;
}

json mesh_json(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  json corners = json::array();
  for (const Triangle& triangle : triangles) {
    for (const int corner : triangle) corners.push_back(corner);
  }
  return {{"points", points_json(points)}, {"triangles", std::move(corners)}};
}

}  // namespace

std::string drape_json(const std::filesystem::path& garment, const std::filesystem::path& dressed,
                       const std::filesystem::path& report, const std::filesystem::path& body,
                       std::vector<std::string> warnings) {
  const PanelMesh meshed = read_garment(garment);
  const DressedGarment worn = read_dressed(dressed);
  // Faces keep their order: they tell which node a material point became.
  std::vector<int> node_of(meshed.flat.size(), 0);
  for (std::size_t t = 0; t < meshed.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) node_of[meshed.triangles[t][i]] = worn.triangles[t][i];
  }
  json seams = json::object();
  for (const MeshedSeam& seam : meshed.seams) {
    json way = json::array();
    for (const int p : seam.a) way.push_back(node_of[p]);
    seams[seam.name] = std::move(way);
  }
  const PolygonSoup skin = read_mesh(body);
  std::vector<Triangle> facets;
  for (const auto& polygon : skin.polygons) {
    if (polygon.size() == 3) facets.push_back({polygon[0], polygon[1], polygon[2]});
  }
  const JsonDocument document(read_file(report), report.string());
  const JsonValue said = document.root();
  for (Warning& warning : read_warnings(said)) warnings.push_back(std::move(warning.text));
  return json{{"garment", mesh_json(worn.points, worn.triangles)},
              {"panels", worn.panel_of_triangle},
              {"seams", std::move(seams)},
              {"body", mesh_json(skin.points, facets)},
              {"verdict", said.get("verdict").text()},
              {"warnings", warnings}}
      .dump();
}

}  // namespace toile
