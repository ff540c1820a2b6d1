#include "io/mesh_file.h"

#include <algorithm>
#include <cctype>

#include "geometry/error.h"
#include "io/mesh_formats.h"
#include "io/obj.h"
#include "io/output_file.h"

namespace toile {

namespace fs = std::filesystem;

namespace {

enum class Format { obj, ply, stl, off };

Format format_of(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".obj") return Format::obj;
  if (extension == ".ply") return Format::ply;
  if (extension == ".stl") return Format::stl;
  if (extension == ".off") return Format::off;
  throw Error(path.string(),
              extension.empty() ? "has no extension"
                                : "'" + extension + "' is not a mesh format Toile knows",
              "use .obj, .ply, .stl or .off");
}

PolygonSoup soup_of(const ObjData& data) {
  PolygonSoup soup;
  soup.points = data.points;
  soup.polygons.reserve(data.faces.size());
  for (const ObjFace& face : data.faces) {
    std::vector<int>& polygon = soup.polygons.emplace_back();
    polygon.reserve(face.corners.size());
    for (const ObjCorner& corner : face.corners) polygon.push_back(corner.point);
  }
  return soup;
}

ObjData obj_of(const TriangleMesh& mesh) {
  ObjData data;
  data.points = mesh.points;
  data.faces.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    data.faces.push_back({{{t[0], -1}, {t[1], -1}, {t[2], -1}}, -1});
  }
  return data;
}

}  // namespace

PolygonSoup read_polygons(const fs::path& path) {
  const std::string name = path.string();
  switch (format_of(path)) {
    case Format::obj:
      return soup_of(read_obj(path));
    case Format::ply:
      return parse_ply(read_file(path), name);
    case Format::stl:
      return parse_stl(read_file(path), name);
    case Format::off:
      return parse_off(read_file(path), name);
  }
  return {};
}

PolygonSoup read_mesh(const fs::path& path) {
  PolygonSoup soup = read_polygons(path);
  if (soup.polygons.empty()) {
    throw Error(path.string(), soup.points.empty() ? "holds no mesh" : "holds points but no faces",
                "export the body as a surface");
  }
  return soup;
}

TriangleMesh fan_triangles(PolygonSoup soup) {
  TriangleMesh mesh;
  mesh.points = std::move(soup.points);
  for (const std::vector<int>& polygon : soup.polygons) {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      mesh.triangles.push_back({polygon[0], polygon[k], polygon[k + 1]});
    }
  }
  return mesh;
}

void write_mesh(const OutputPath& path, const TriangleMesh& mesh,
                const MeshProperties& properties) {
  const Format format = format_of(path.path());
  const bool is_plain =
      properties.colours.empty() && properties.points.empty() && properties.triangles.empty();
  if (!is_plain && format != Format::ply) {
    throw Error(path.path().string(), "only PLY can hold colours and values", "use .ply");
  }
  switch (format) {
    case Format::obj:
      return write_obj(path, obj_of(mesh));
    case Format::ply:
      return write_file(path, format_ply(mesh, properties));
    case Format::stl:
      return write_file(path, format_stl(mesh));
    case Format::off:
      return write_file(path, format_off(mesh));
  }
}

void check_mesh_extension(const fs::path& path) { format_of(path); }

}  // namespace toile
