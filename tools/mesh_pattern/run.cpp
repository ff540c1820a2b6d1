#include "tools/mesh_pattern/run.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "geometry/error.h"
#include "io/output_file.h"
#include "pattern/check/check_pattern.h"
#include "pattern/check/left_out.h"
#include "pattern/file/garment_file.h"
#include "pattern/file/pattern_file.h"
#include "tools/mesh_pattern/report.h"
#include "tools/remarks.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace po = boost::program_options;

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

void say_all(const PanelMesh& garment, const std::vector<PanelMeasurements>& measured,
             const CommonSettings& common) {
  double smallest = std::numbers::pi;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const MeshedPanel& panel = garment.panels[p];
    smallest = std::min(smallest, measured[p].smallest_angle);
    common.say(line("  panel %-20s %6d points %6d triangles  %7.1f cm2  smallest angle %4.1f deg",
                    panel.name.c_str(), panel.points, panel.triangles, measured[p].area * 1e4,
                    measured[p].smallest_angle * degrees));
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

}  // namespace

void add_edge_length_option(po::options_description& options) {
  options.add_options()("edge-length", po::value<std::string>()->default_value("10mm"),
                        "length of triangle edges");
}

double read_edge_length(const po::variables_map& given) {
  return parse_length(given["edge-length"].as<std::string>(), "--edge-length");
}

MeshedPattern mesh_pattern(const std::string& text, const std::string& name,
                           const MeshPatternSettings& settings) {
  MeshedPattern meshed;
  std::vector<Remark>& remarks = meshed.remarks;
  const Pattern pattern = without_left_out(parse_pattern(text, name, remarks), remarks);
  check_pattern(pattern, remarks);
  PanelMesh& garment = meshed.garment;
  garment = mesh_panels(pattern, settings.mesh, remarks);
  for (const MeshedPanel& panel : garment.panels) {
    meshed.measured.push_back(measure_panel(garment, panel));
  }
  if (settings.flat) lay_flat(garment);
  return meshed;
}

std::vector<std::string> run_mesh_pattern(const MeshPatternSettings& settings,
                                          const CommonSettings& common) {
  const std::string name = settings.pattern.string();
  const auto [garment, measured, remarks] =
      mesh_pattern(read_file(settings.pattern), name, settings);
  say_remarks(remarks, common);
  say_all(garment, measured, common);
  OutputFiles files;
  write_garment(files.at(common.output), garment);
  write_report(files, common, mesh_pattern_json(name, garment, measured, remarks));
  files.commit();
  return warnings_in(remarks);
}

}  // namespace toile
