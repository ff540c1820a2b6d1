#include "tools/edit_seams/drape_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/json_value.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "pattern/file/garment_file.h"
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

std::string count_of(const JsonValue& intersections, const char* with) {
  const auto count = intersections.find(with);
  return std::to_string(count ? std::lround(count->number()) : 0);
}

/// Why the verdict is not `sewn`: the warning of dress that says so; empty where there is none.
/// What crosses is counted, and a panel that starts in the wrong place is why.
std::string reason_of(const std::string& verdict, const JsonValue& report,
                      const std::vector<Warning>& warnings) {
  std::vector<std::string> codes = {verdict == "unsewable" ? "seams_open" : verdict};
  std::string crossings;
  if (verdict == "intersecting") {
    codes = {"inside_out", "swapped", "other_side", "starts_inside"};
    const JsonValue met = report.get("intersections");
    crossings = "pairs of triangles that cross: " + count_of(met, "body") + " with the body, " +
                count_of(met, "self") + " of the garment itself";
  }
  const auto why = std::ranges::find_first_of(warnings, codes, {}, &Warning::code);
  if (why == warnings.end()) return crossings;
  return crossings + (crossings.empty() ? "" : "; ") + why->text;
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
  const std::vector<Warning> of_drape = read_warnings(said);
  for (const Warning& warning : of_drape) warnings.push_back(warning.text);
  const std::string verdict = said.get("verdict").text();
  return json{{"garment", mesh_json(worn.points, worn.triangles)},
              {"panels", worn.panel_of_triangle},
              {"seams", std::move(seams)},
              {"body", mesh_json(skin.points, facets)},
              {"verdict", verdict},
              {"reason", reason_of(verdict, said, of_drape)},
              {"warnings", warnings}}
      .dump();
}

}  // namespace toile
