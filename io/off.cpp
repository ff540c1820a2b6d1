// Object File Format [Geomview], as text only. Normals and colours of its variants are skipped.
#include <limits>

#include "io/limits.h"
#include "io/line_scanner.h"
#include "io/mesh_formats.h"
#include "io/text.h"

namespace toile {

PolygonSoup parse_off(std::string_view data, const std::string& name) {
  LineScanner scanner(data, name);
  if (!scanner.next_line('#')) scanner.fail("the file is empty", "give an OFF file");
  const std::string_view keyword = scanner.word();
  if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF") {
    scanner.fail("begins with " + shown(keyword) + " instead of OFF", "is it really an OFF file?");
  }
  std::string_view after = scanner.rest();
  if (after.find_first_not_of(" \t") == std::string_view::npos) {
    scanner.need_line("its counts", '#');
  } else if (after.find("BINARY") != std::string_view::npos) {
    scanner.fail("binary OFF can't be read", "save it as text");
  }
  constexpr long long max_count = std::numeric_limits<int>::max();
  const long long points = scanner.integer("the number of points", 0, max_count);
  const long long polygons = scanner.integer("the number of faces", 0, max_count);

  PolygonSoup soup;
  for (long long i = 0; i < points; ++i) {
    scanner.need_line("point " + std::to_string(i + 1) + " of " + std::to_string(points), '#');
    Vec3& point = soup.points.emplace_back();
    for (int axis = 0; axis < 3; ++axis) point[axis] = scanner.coordinate();
  }
  for (long long i = 0; i < polygons; ++i) {
    scanner.need_line("face " + std::to_string(i + 1) + " of " + std::to_string(polygons), '#');
    const long long corners = scanner.integer("the number of corners", 3, max_face_corners);
    std::vector<int>& polygon = soup.polygons.emplace_back();
    for (long long corner = 0; corner < corners; ++corner) {
      polygon.push_back(static_cast<int>(scanner.integer("a point's index", 0, points - 1)));
    }
  }
  return soup;
}

std::string format_off(const TriangleMesh& mesh) {
  std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " +
                     std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& point : mesh.points) {
    for (int axis = 0; axis < 3; ++axis) {
      append_number(text, point[axis]);
      text += axis < 2 ? ' ' : '\n';
    }
  }
  for (const Triangle& t : mesh.triangles) {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
            "\n";
  }
  return text;
}

}  // namespace toile
