#include "tools/measure_body/page.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/text.h"
#include "io/view/picture.h"
#include "io/view/viewer_page.h"

namespace toile {

namespace {

constexpr Colour skin{0.80, 0.76, 0.73};
// Metres. In the page thinner lines vanish beside the body.
constexpr double picture_line = 0.0022;
constexpr double page_line = 0.004;
constexpr double dot_radius = 0.006;  // metres

/// A tube of six sides around a polyline.
void add_tube(TriangleMesh& mesh, const std::vector<Vec3>& line, double radius) {
  constexpr int sides = 6;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 along = line[i + 1] - line[i];
    if (along.norm() < 1e-9) continue;
    const Vec3 u = along.unitOrthogonal();
    const Vec3 v = along.normalized().cross(u);
    const int first = static_cast<int>(mesh.points.size());
    for (const Vec3& end : {line[i], line[i + 1]}) {
      for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        mesh.points.push_back(end + radius * (std::cos(angle) * u + std::sin(angle) * v));
      }
    }
    for (int k = 0; k < sides; ++k) {
      const int next = (k + 1) % sides;
      mesh.triangles.push_back({first + k, first + next, first + sides + k});
      mesh.triangles.push_back({first + next, first + sides + next, first + sides + k});
    }
  }
}

/// A dot of eight triangles.
void add_dot(TriangleMesh& mesh, const Vec3& at) {
  const int first = static_cast<int>(mesh.points.size());
  for (const double sign : {1.0, -1.0}) {
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      mesh.points.push_back(at + sign * dot_radius * axis);
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const int x = first + ((corner & 1) != 0 ? 3 : 0);
    const int y = first + ((corner & 2) != 0 ? 4 : 1);
    const int z = first + ((corner & 4) != 0 ? 5 : 2);
    const bool odd = ((corner & 1) + ((corner >> 1) & 1) + ((corner >> 2) & 1)) % 2 != 0;
    mesh.triangles.push_back(odd ? Triangle{x, z, y} : Triangle{x, y, z});
  }
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::vector<const Measure*> all_of(const MeasuredBody& measures) {
  std::vector<const Measure*> all;
  for (const Measure& measure : measures.measures) all.push_back(&measure);
  for (const Measure& measure : measures.freehand) all.push_back(&measure);
  return all;
}

}  // namespace

std::string measures_page(const TriangleMesh& body, const MeasuredBody& measures) {
  ViewerPage page;
  page.title = "Measures of " + measures.body_name;
  page.paragraphs = {
      "Click a row, and its measure lights on the body. Girths are taken as a tape lies, over what "
      "is hollow."};
  page.settings.push_back({"body", body});
  PageMap lengths;
  lengths.tab = "Length";
  lengths.reading = "length";
  lengths.unit = measures.unit;
  TriangleMesh lines;
  PageTable table{"Measures", {"measure", "value", "ISO 8559-1", "how it is taken"}, {}, {}, ""};
  PageTable missing{"Not taken", {"measure", "why"}, {}, {}, ""};
  double longest = 1;
  for (const Measure* measure : all_of(measures)) {
    if (!measure->value) {
      missing.rows.push_back({spaced(measure->name), measure->reason});
      continue;
    }
    const double value = measures.shown(*measure);
    std::string text = fixed_number(value, 1);
    if (measure->plus_minus > 0) text += " ± " + fixed_number(measures.shown_error(*measure), 1);
    table.rows.push_back({spaced(measure->name),
                          text + (measure->is_angle ? " deg" : " " + measures.unit), measure->iso,
                          measure->definition});
    if (measure->is_angle) {
      // Colours are of lengths.
      table.regions.push_back(-1);
      continue;
    }
    longest = std::max(longest, value);
    const std::size_t before = lines.triangles.size();
    for (const std::vector<Vec3>& line : measure->lines) add_tube(lines, line, page_line);
    lengths.values.resize(lines.points.size(), value);
    const int region = static_cast<int>(page.regions.size());
    page.region_of_triangle.insert(page.region_of_triangle.end(), lines.triangles.size() - before,
                                   region);
    page.regions.push_back(spaced(measure->name));
    table.regions.push_back(region);
  }
  lengths.bar = {"Length, " + measures.unit, magnitude_ramp(0, round_up(longest))};
  page.maps.push_back(std::move(lengths));
  page.nodes = std::move(lines.points);
  page.triangles = std::move(lines.triangles);
  page.tables.push_back(table);
  if (!missing.rows.empty()) page.tables.push_back(missing);
  page.still_png = measures_picture(body, measures);
  return viewer_page(page);
}

std::string measures_picture(const TriangleMesh& body, const MeasuredBody& measures) {
  PictureMesh skin_mesh;
  skin_mesh.mesh = body;
  skin_mesh.colour = skin;
  PictureMesh lines;
  lines.colour = Colour{0.10, 0.25, 0.55};
  for (const Measure* measure : all_of(measures)) {
    for (const std::vector<Vec3>& line : measure->lines) add_tube(lines.mesh, line, picture_line);
  }
  PictureMesh dots;
  dots.colour = Colour{0.80, 0.15, 0.12};
  for (const Landmark& landmark : measures.landmarks) {
    if (landmark.place) add_dot(dots.mesh, *landmark.place);
  }
  Picture picture;
  picture.views = {View::front, View::left, View::back};
  picture.view_width = 700;
  picture.title = "Measures and landmarks of " + measures.body_name;
  picture.legend = {{lines.colour, "measures"}, {dots.colour, "landmarks"}};
  std::vector<PictureMesh> meshes = {std::move(skin_mesh)};
  for (PictureMesh* mesh : {&lines, &dots}) {
    if (!mesh->mesh.triangles.empty()) meshes.push_back(std::move(*mesh));
  }
  return picture_png(std::move(meshes), picture);
}

}  // namespace toile
