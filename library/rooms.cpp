#include "library/rooms.h"

#include <cmath>

#include "cloth/scene/closed_body.h"
#include "io/json_value.h"
#include "io/limits.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "pattern/file/garment_file.h"

namespace toile {

namespace {

template <int n, std::size_t m>
std::vector<Eigen::Matrix<double, n, 1>> vectors(const std::vector<std::array<double, m>>& points,
                                                 const std::string& name) {
  std::vector<Eigen::Matrix<double, n, 1>> all;
  all.reserve(points.size());
  for (const auto& point : points) {
    for (const double coordinate : point) {
      const std::string problem = coordinate_problem(coordinate, max_coordinate);
      if (!problem.empty()) {
        throw Error(name, "point " + std::to_string(all.size()) + ": " + problem, "");
      }
    }
    all.emplace_back(point.data());
  }
  return all;
}

void check_corners(const std::vector<Triangle>& triangles, std::size_t points,
                   const std::string& name) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const int corner : triangles[t]) {
      if (corner >= 0 && static_cast<std::size_t>(corner) < points) continue;
      throw Error(name,
                  "triangle " + std::to_string(t) + " has the point " + std::to_string(corner) +
                      " of " + std::to_string(points),
                  "indices count from 0");
    }
  }
}

/// Panels without a fabric of their own are of the garment's. The report names it.
void name_fabrics(const std::string& report, DressedGarment& drape) {
  if (report.empty()) return;
  const JsonDocument document(report, "report");
  const auto scene = document.root().find("scene");
  const auto fabrics = scene ? scene->find("fabrics") : std::nullopt;
  for (std::size_t i = 0; fabrics && i < fabrics->size(); ++i) {
    const JsonValue panels = fabrics->item(i).get("panels");
    const std::string name = fabrics->item(i).get("quantities").get("name").text();
    for (std::size_t k = 0; k < panels.size(); ++k) {
      for (std::size_t p = 0; p < drape.panels.size(); ++p) {
        const bool is_it = valid_utf8(drape.panels[p]) == panels.item(k).text();
        if (is_it && drape.fabrics[p].empty()) drape.fabrics[p] = name;
      }
    }
  }
}

}  // namespace

TriangleMesh mesh_in(const std::vector<library::Point>& points,
                     const std::vector<library::Corners>& triangles, const std::string& name) {
  check_corners(triangles, points.size(), name);
  return {vectors<3>(points, name), triangles};
}

std::vector<library::Point> points_out(const std::vector<Vec3>& points) {
  std::vector<library::Point> all;
  all.reserve(points.size());
  for (const Vec3& point : points) all.push_back({point.x(), point.y(), point.z()});
  return all;
}

TriangleMesh skin_in(const library::Body& body) {
  return closed_body(mesh_in(body.points, body.triangles, "body"), "body");
}

std::optional<Skeleton> skeleton_in(const library::Body& body) {
  if (body.joints.empty()) return std::nullopt;
  return parse_skeleton(body.joints, "joints");
}

library::Body body_out(const TriangleMesh& skin, const std::optional<Skeleton>& skeleton,
                       const Landmarks& landmarks) {
  return {points_out(skin.points), skin.triangles,
          skeleton ? format_skeleton(*skeleton, landmarks) : "", ""};
}

PanelMesh garment_in(const library::Garment& garment) {
  PanelMesh mesh;
  mesh.flat = vectors<2>(garment.flat, "garment");
  mesh.placed = vectors<3>(garment.placed, "garment");
  mesh.triangles = garment.triangles;
  check_corners(mesh.triangles, mesh.flat.size(), "garment");
  if (mesh.placed.size() != mesh.flat.size()) {
    throw Error("garment", "has other numbers of flat and placed points", "give one of each");
  }
  return parse_garment(std::move(mesh), "garment", garment.json, "garment.json");
}

library::Garment garment_out(const PanelMesh& garment) {
  library::Garment out;
  out.flat.reserve(garment.flat.size());
  for (const Vec2& point : garment.flat) out.flat.push_back({point.x(), point.y()});
  out.placed = points_out(garment.placed);
  out.triangles = garment.triangles;
  out.json = garment_json(garment);
  return out;
}

DressedGarment drape_in(const library::Drape& drape) {
  TriangleMesh cloth = mesh_in(drape.points, drape.triangles, "drape");
  const PanelMesh garment = garment_in(drape.garment);
  if (cloth.triangles.size() != garment.triangles.size()) {
    throw Error("drape", "has other triangles than its garment",
                "give the garment that was dressed");
  }
  DressedGarment dressed = as_dressed(garment, std::move(cloth.points), std::move(cloth.triangles));
  name_fabrics(drape.report, dressed);
  return dressed;
}

CommonSettings settings_of(const std::string& program) {
  CommonSettings common;
  common.quiet = true;
  common.program = program;
  return common;
}

}  // namespace toile
