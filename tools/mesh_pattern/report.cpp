#include "tools/mesh_pattern/report.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/triangulate.h"
#include "pattern/classify/panel_class_json.h"
#include "tools/remarks.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

PanelMeasurements measure_panel(const PanelMesh& garment, const MeshedPanel& panel) {
  PanelMeasurements measured{0, std::numbers::pi, 1e300, 0};
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    std::array<Vec2, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] =
          garment.flat[static_cast<std::size_t>(garment.triangles[static_cast<std::size_t>(t)][k])];
    }
    const Vec2 u = corners[1] - corners[0];
    const Vec2 v = corners[2] - corners[0];
    measured.area += (u.x() * v.y() - u.y() * v.x()) / 2;
    measured.smallest_angle =
        std::min(measured.smallest_angle, smallest_angle(corners[0], corners[1], corners[2]));
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (corners[(k + 1) % 3] - corners[k]).norm();
      measured.shortest_edge = std::min(measured.shortest_edge, length);
      measured.longest_edge = std::max(measured.longest_edge, length);
    }
  }
  return measured;
}

nlohmann::ordered_json mesh_pattern_json(const std::string& pattern, const PanelMesh& garment,
                                         const std::vector<PanelMeasurements>& measured,
                                         const std::vector<Remark>& remarks) {
  constexpr double degrees = 180 / std::numbers::pi;
  Json report;
  report["pattern"] = pattern;
  report["garment"] = {
      {"material_points", garment.flat.size()}, {"triangles", garment.triangles.size()},
      {"panels", garment.panels.size()},        {"seams", garment.seams.size()},
      {"cut_outs", garment.cut_outs.size()},    {"marks", garment.marks.size()}};
  report["edge_length_mm"] = 1000 * garment.edge_length;
  report["subdivisions"] = garment.subdivisions;
  report["panels"] = Json::array();
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    report["panels"].push_back({{"name", garment.panels[p].name},
                                {"material_points", garment.panels[p].points},
                                {"triangles", garment.panels[p].triangles},
                                {"area_cm2", 1e4 * measured[p].area},
                                {"smallest_angle_degrees", measured[p].smallest_angle * degrees},
                                {"shortest_edge_mm", 1000 * measured[p].shortest_edge},
                                {"longest_edge_mm", 1000 * measured[p].longest_edge},
                                {"is", text_of(garment.panels[p].is)},
                                {"class", panel_class_json(garment.panels[p].is)}});
  }
  report["seams"] = Json::array();
  for (const MeshedSeam& seam : garment.seams) {
    report["seams"].push_back({{"name", seam.name},
                               {"points", seam.a.size()},
                               {"length_a_cm", 100 * seam.length_a},
                               {"length_b_cm", 100 * seam.length_b}});
  }
  add_remarks(remarks, report);
  return report;
}

}  // namespace toile
