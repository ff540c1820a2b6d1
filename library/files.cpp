#include "toile/files.h"

#include <nlohmann/json.hpp>

#include "cloth/scene/closed_body.h"
#include "io/checksum.h"
#include "io/json_value.h"
#include "io/mesh_file.h"
#include "io/obj.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "library/rooms.h"
#include "pattern/file/garment_file.h"
#include "pattern/file/pattern_file.h"
#include "tools/ease_map/dress_report.h"

namespace toile {
inline namespace library {

namespace {

namespace fs = std::filesystem;

Mesh mesh_out(const TriangleMesh& mesh) { return {points_out(mesh.points), mesh.triangles}; }

}  // namespace

Mesh read_mesh(const fs::path& file) {
  return guarded([&] { return mesh_out(fan_triangles(read_polygons(file))); });
}

Body read_body(const fs::path& file) {
  return guarded([&] {
    const Mesh skin = mesh_out(read_closed_body(file));
    Body body{skin.points, skin.triangles, "", ""};
    const fs::path joints = skeleton_beside(file);
    if (fs::exists(joints)) {
      read_skeleton_of(SurfaceDistance(mesh_in(body.points, body.triangles, file.string())),
                       joints);
      body.joints = read_file(joints);
    }
    return body;
  });
}

SewingPattern read_pattern(const fs::path& file) {
  return guarded([&] {
    SewingPattern pattern{read_file(file), file.string(), ""};
    std::vector<Remark> remarks;
    parse_pattern(pattern.json, pattern.name, remarks);
    return pattern;
  });
}

Garment read_garment(const fs::path& file) {
  return guarded([&] { return garment_out(toile::read_garment(file, {}, nullptr)); });
}

Drape read_drape(const fs::path& file, const Garment& garment) {
  return guarded([&] {
    DressedGarment dressed = read_dressed(file);
    Drape drape{points_out(dressed.points), dressed.triangles, garment, {}, ""};
    const DressedGarment again = drape_in(drape);
    if (again.flat != dressed.flat || again.flat_triangles != dressed.flat_triangles) {
      throw Error(file.string(), "is a drape of another garment", "give the one that was dressed");
    }
    const fs::path report = dress_report_path(file);
    if (fs::exists(report) && read_dress_report(report, file)) drape.report = read_file(report);
    return drape;
  });
}

void write(const Body& body, const fs::path& file) {
  guarded([&] {
    OutputFiles files;
    write_mesh(files.at(file), mesh_in(body.points, body.triangles, "body"));
    if (!body.joints.empty()) write_file(files.at(skeleton_path(file)), body.joints);
    files.commit();
  });
}

void write(const SewingPattern& pattern, const fs::path& file) {
  guarded([&] { write_file(file, pattern.json); });
}

void write(const Garment& garment, const fs::path& file) {
  guarded([&] { write_garment(file, garment_in(garment)); });
}

void write(const Drape& drape, const fs::path& file) {
  guarded([&] {
    OutputFiles files;
    write_dressed(files.at(file), drape_in(drape));
    if (!drape.report.empty()) write_file(files.at(dress_report_path(file)), drape.report);
    files.commit();
  });
}

}  // namespace library
}  // namespace toile
