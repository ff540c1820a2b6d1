// mesh-pattern: from a flat sewing pattern to meshed panels with paired seams.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/error.h"
#include "geometry/triangulate.h"
#include "io/output_file.h"
#include "pattern/check_pattern.h"
#include "pattern/garment_file.h"
#include "pattern/mesh_panels.h"
#include "pattern/pattern_file.h"
#include "tools/programs.h"

namespace toile {

namespace {

namespace po = boost::program_options;
using Json = nlohmann::ordered_json;

struct Settings {
  std::filesystem::path pattern;
  MeshSettings mesh;
  bool flat = false;
};

/// What is measured on a meshed panel.
struct PanelFigures {
  double area = 0;            ///< square metres
  double smallest_angle = 0;  ///< radians
  double shortest_edge = 0;   ///< metres
  double longest_edge = 0;
};

PanelFigures figures_of(const PanelMesh& garment, const MeshedPanel& panel) {
  PanelFigures figures{0, std::numbers::pi, 1e300, 0};
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    std::array<Vec2, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] =
          garment.flat[static_cast<std::size_t>(garment.triangles[static_cast<std::size_t>(t)][k])];
    }
    const Vec2 u = corners[1] - corners[0];
    const Vec2 v = corners[2] - corners[0];
    figures.area += (u.x() * v.y() - u.y() * v.x()) / 2;
    figures.smallest_angle =
        std::min(figures.smallest_angle, smallest_angle(corners[0], corners[1], corners[2]));
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (corners[(k + 1) % 3] - corners[k]).norm();
      figures.shortest_edge = std::min(figures.shortest_edge, length);
      figures.longest_edge = std::max(figures.longest_edge, length);
    }
  }
  return figures;
}

/// Lays the panels side by side on z = 0 instead of around the body.
void lay_flat(PanelMesh& garment) {
  constexpr double gap = 0.02;
  double right = 0;
  for (const MeshedPanel& panel : garment.panels) {
    const auto first = static_cast<std::size_t>(panel.first_point);
    const auto last = first + static_cast<std::size_t>(panel.points);
    Vec2 low = garment.flat[first];
    double high = low.x();
    for (std::size_t i = first; i < last; ++i) {
      low = low.cwiseMin(garment.flat[i]);
      high = std::max(high, garment.flat[i].x());
    }
    for (std::size_t i = first; i < last; ++i) {
      const Vec2 point = garment.flat[i] - low;
      garment.placed[i] = Vec3(right + point.x(), point.y(), 0);
    }
    right += high - low.x() + gap;
  }
}

template <class... Arguments>
std::string line(const char* format, Arguments... arguments) {
  char text[512];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

constexpr double degrees = 180 / std::numbers::pi;

void say_all(const PanelMesh& garment, const std::vector<PanelFigures>& figures,
             const CommonSettings& common) {
  double smallest = std::numbers::pi;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const MeshedPanel& panel = garment.panels[p];
    smallest = std::min(smallest, figures[p].smallest_angle);
    common.say(line("  panel %-20s %6d points %6d triangles  %7.1f cm2  smallest angle %4.1f deg",
                    panel.name.c_str(), panel.points, panel.triangles, figures[p].area * 1e4,
                    figures[p].smallest_angle * degrees));
  }
  for (const MeshedSeam& seam : garment.seams) {
    common.say(line("  seam %-40s %4zu points  %6.2f cm to %6.2f cm", seam.name.c_str(),
                    seam.a.size(), seam.length_a * 100, seam.length_b * 100));
  }
  common.say(
      line("%zu panels, %zu points, %zu triangles, %zu seams, %d subdivisions, "
           "smallest angle %.1f deg",
           garment.panels.size(), garment.flat.size(), garment.triangles.size(),
           garment.seams.size(), garment.subdivisions, smallest * degrees));
}

Json report_of(const Settings& settings, const PanelMesh& garment,
               const std::vector<PanelFigures>& figures, const std::vector<Remark>& remarks,
               double seconds) {
  Json report;
  report["program"] = "mesh-pattern";
  report["pattern"] = settings.pattern.string();
  report["garment"] = {{"vertices", garment.flat.size()},
                       {"triangles", garment.triangles.size()},
                       {"panels", garment.panels.size()},
                       {"seams", garment.seams.size()}};
  report["edge_length"] = garment.edge_length;
  report["subdivisions"] = garment.subdivisions;
  report["seconds"] = seconds;
  report["panels"] = Json::array();
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    report["panels"].push_back({{"name", garment.panels[p].name},
                                {"vertices", garment.panels[p].points},
                                {"triangles", garment.panels[p].triangles},
                                {"area", figures[p].area},
                                {"smallest_angle_degrees", figures[p].smallest_angle * degrees},
                                {"shortest_edge", figures[p].shortest_edge},
                                {"longest_edge", figures[p].longest_edge}});
  }
  report["seams"] = Json::array();
  for (const MeshedSeam& seam : garment.seams) {
    report["seams"].push_back({{"name", seam.name},
                               {"points", seam.a.size()},
                               {"length_a", seam.length_a},
                               {"length_b", seam.length_b}});
  }
  report["notes"] = Json::array();
  report["warnings"] = Json::array();
  for (const Remark& remark : remarks) {
    report[remark.warning ? "warnings" : "notes"].push_back(remark.text);
  }
  return report;
}

int work(const Settings& settings, const CommonSettings& common) {
  const auto start = std::chrono::steady_clock::now();
  // garment.json goes beside garment.obj: it must not take the pattern's own place.
  const std::filesystem::path json =
      std::filesystem::path(common.output).replace_extension(".json");
  std::error_code absent;
  if (std::filesystem::equivalent(json, settings.pattern, absent)) {
    throw Error("-o " + common.output.string(), "would write " + json.string() + ", the pattern",
                "name the garment otherwise");
  }
  std::vector<Remark> remarks;
  const Pattern pattern = read_pattern(settings.pattern, remarks);
  check_pattern(pattern, remarks);
  PanelMesh garment = mesh_panels(pattern, settings.mesh, remarks);
  for (const Remark& remark : remarks) {
    if (remark.warning) {
      CommonSettings::warn(remark.text);
    } else {
      common.say("note: " + remark.text);
    }
  }
  std::vector<PanelFigures> figures;
  for (const MeshedPanel& panel : garment.panels) figures.push_back(figures_of(garment, panel));
  say_all(garment, figures, common);
  if (settings.flat) lay_flat(garment);
  write_garment(common.output, garment);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (common.report) {
    write_file(*common.report,
               report_of(settings, garment, figures, remarks, seconds.count()).dump(2) + "\n");
  }
  return exit_done;
}

}  // namespace

CommandLineProgram mesh_pattern_program() {
  CommandLineProgram program;
  program.name = "mesh-pattern";
  program.summary = "meshes the panels of a sewing pattern, seam sides point to point";
  program.usage = "PATTERN.json -o garment.obj [--edge-length 10mm]";
  program.options.add_options()("edge-length", po::value<std::string>()->default_value("10mm"),
                                "length of triangle edges")(
      "subdivisions", po::value<int>()->default_value(-1),
      "levels of the nested triangulation, 0 to 3; -1 chooses by edge length")(
      "flat", po::bool_switch(), "lay the panels out flat instead of placing them")(
      "pattern", po::value<std::string>()->required(), "the pattern (also without --pattern)");
  program.positional.add("pattern", 1);
  program.output_extensions = {".obj"};  // garment.json is written beside it
  program.work = [](const po::variables_map& given, const CommonSettings& common) {
    Settings settings;
    settings.pattern = given["pattern"].as<std::string>();
    settings.mesh.edge_length =
        parse_length(given["edge-length"].as<std::string>(), "--edge-length");
    settings.mesh.subdivisions = given["subdivisions"].as<int>();
    if (settings.mesh.subdivisions > max_subdivisions) {
      throw Error("--subdivisions", "is more than " + std::to_string(max_subdivisions),
                  "use 0 to 3, or -1");
    }
    settings.flat = given["flat"].as<bool>();
    return work(settings, common);
  };
  return program;
}

}  // namespace toile
