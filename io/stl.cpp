// Stereolithography files: separate triangles, as text or as 50-byte binary records of floats.
#include <cstdint>

#include "geometry/error.h"
#include "io/bytes.h"
#include "io/limits.h"
#include "io/line_scanner.h"
#include "io/mesh_formats.h"

namespace toile {

namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t first_record = header_bytes + 4;
constexpr std::size_t record_bytes = 50;  // normal, three points, two bytes of attributes

PolygonSoup parse_binary(std::string_view data, const std::string& name) {
  if (data.size() < first_record) {
    throw Error(name, "is too short for an STL file (" + std::to_string(data.size()) + " bytes)",
                "is it cut off?");
  }
  const std::uint64_t count = load<std::uint32_t>(&data[header_bytes], std::endian::little);
  if (data.size() != first_record + count * record_bytes) {
    throw Error(name + ", byte 80",
                "announces " + std::to_string(count) + " triangles, which take " +
                    std::to_string(first_record + count * record_bytes) + " bytes, but has " +
                    std::to_string(data.size()),
                "is it really an STL file, and whole?");
  }
  PolygonSoup soup;
  soup.points.reserve(3 * count);
  soup.polygons.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    std::size_t at = first_record + i * record_bytes + 12;
    const int first = static_cast<int>(soup.points.size());
    for (int corner = 0; corner < 3; ++corner) {
      Vec3& point = soup.points.emplace_back();
      for (int axis = 0; axis < 3; ++axis, at += 4) {
        point[axis] = load<float>(&data[at], std::endian::little);
        const std::string problem = coordinate_problem(point[axis]);
        if (!problem.empty()) {
          throw Error(name + ", byte " + std::to_string(at),
                      "triangle " + std::to_string(i + 1) + ": " + problem, coordinate_remedy);
        }
      }
    }
    soup.polygons.push_back({first, first + 1, first + 2});
  }
  return soup;
}

void expect(LineScanner& scanner, const std::string& statement) {
  scanner.need_line(statement);
  const std::string_view line = scanner.rest();
  LineScanner wanted(statement, "");
  wanted.next_line();
  for (std::string_view word = wanted.word(); !word.empty(); word = wanted.word()) {
    if (scanner.word() != word) {
      scanner.fail(shown(line) + " stands where " + shown(statement) + " should", "");
    }
  }
}

PolygonSoup parse_text(std::string_view data, const std::string& name) {
  LineScanner scanner(data, name);
  PolygonSoup soup;
  bool open = false;  // whether between solid and endsolid; a file may hold several solids
  while (scanner.next_line()) {
    const std::string_view line = scanner.rest();
    const std::string_view keyword = scanner.word();
    if (keyword == (open ? "endsolid" : "solid")) {
      open = !open;
      continue;
    }
    if (!open || keyword != "facet") scanner.fail(shown(line) + " is out of place", "");
    expect(scanner, "outer loop");
    const int first = static_cast<int>(soup.points.size());
    for (int corner = 0; corner < 3; ++corner) {
      expect(scanner, "vertex");
      Vec3& point = soup.points.emplace_back();
      for (int axis = 0; axis < 3; ++axis) point[axis] = scanner.coordinate();
    }
    expect(scanner, "endloop");
    expect(scanner, "endfacet");
    soup.polygons.push_back({first, first + 1, first + 2});
  }
  if (open) scanner.fail("the file ends before 'endsolid'", "is it cut off?");
  return soup;
}

}  // namespace

PolygonSoup parse_stl(std::string_view data, const std::string& name) {
  if (data.empty()) throw Error(name, "the file is empty", "give an STL file");
  // Some programs begin binary files with "solid" too, so the size decides first.
  const bool binary_size =
      data.size() >= first_record &&
      data.size() == first_record + record_bytes * std::uint64_t{load<std::uint32_t>(
                                                       &data[header_bytes], std::endian::little)};
  const bool text = !binary_size && data.substr(0, 5) == "solid";
  return text ? parse_text(data, name) : parse_binary(data, name);
}

std::string format_stl(const TriangleMesh& mesh) {
  std::string bytes(header_bytes, ' ');
  bytes.reserve(first_record + record_bytes * mesh.triangles.size());
  store(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  const auto store_vector = [&bytes](const Vec3& vector) {
    for (int axis = 0; axis < 3; ++axis) store(bytes, static_cast<float>(vector[axis]));
  };
  for (const Triangle& t : mesh.triangles) {
    // Readers take the normal from the corners' order when it is zero, as the format allows.
    store_vector(Vec3::Zero());
    for (const int corner : t) store_vector(mesh.points[corner]);
    store(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace toile
