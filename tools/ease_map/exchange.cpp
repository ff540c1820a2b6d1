#include "tools/ease_map/exchange.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "geometry/vertex_normals.h"
#include "io/gltf.h"
#include "io/text.h"
#include "pattern/layout/side_by_side.h"
#include "tools/ease_map/maps.h"
#include "tools/program.h"

namespace toile {

namespace {

constexpr Colour skin_colour{0.80, 0.76, 0.73};

/// Which fabric each panel is cut from: an index into the names.
struct PanelFabrics {
  std::vector<std::string> names;
  std::vector<int> of_panel;
};

/// The report of dress tells them; without it all panels are of one cloth.
PanelFabrics fabrics_of(const EaseReport& report) {
  PanelFabrics fabrics;
  fabrics.of_panel.assign(report.garment.panels.size(), -1);
  if (report.dressing) {
    for (const UsedFabric& used : report.dressing->fabrics) {
      for (std::size_t p = 0; p < report.garment.panels.size(); ++p) {
        const std::string name = valid_utf8(report.garment.panels[p]);
        if (std::ranges::find(used.panels, name) == used.panels.end()) continue;
        fabrics.of_panel[p] = static_cast<int>(fabrics.names.size());
      }
      fabrics.names.push_back(used.fabric.name);
    }
  }
  if (std::ranges::find(fabrics.of_panel, -1) != fabrics.of_panel.end()) {
    std::ranges::replace(fabrics.of_panel, -1, static_cast<int>(fabrics.names.size()));
    fabrics.names.emplace_back("cloth");
  }
  return fabrics;
}

/// The garment's panels that have triangles, and the node of each of their points.
struct PanelMeshes {
  std::vector<GltfMesh> meshes;
  std::vector<std::vector<int>> nodes;
};

PanelMeshes panel_meshes(const EaseReport& report) {
  const DressedGarment& garment = report.garment;
  const std::vector<Vec3> normals = vertex_normals(garment.points, garment.triangles);
  const std::vector<Colour> colours = ease_properties(report).colours;
  const SideBySide laid = side_by_side(garment);
  const PanelFabrics fabrics = fabrics_of(report);
  PanelMeshes panels;
  panels.meshes.resize(garment.panels.size());
  panels.nodes.resize(garment.panels.size());
  std::map<std::array<int, 3>, int> point_of;  // of a panel, a flat point and a node
  for (const PointGap& point : report.map.points) {
    const auto p = static_cast<std::size_t>(point.panel);
    GltfMesh& mesh = panels.meshes[p];
    point_of[{point.panel, point.flat, point.node}] = static_cast<int>(mesh.points.size());
    mesh.points.push_back(garment.points[point.node]);
    mesh.normals.push_back(normals[point.node]);
    mesh.colours.push_back(colours[point.node]);
    if (mesh.maps.empty()) mesh.maps.resize(2);
    mesh.maps[0].push_back(garment.flat[point.flat]);
    mesh.maps[1].push_back(laid.flat[point.flat] / laid.size.maxCoeff());
    panels.nodes[p].push_back(point.node);
  }
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const int panel = garment.panel_of_triangle[t];
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = point_of.at({panel, garment.flat_triangles[t][k], garment.triangles[t][k]});
    }
    panels.meshes[static_cast<std::size_t>(panel)].triangles.push_back(triangle);
  }
  for (std::size_t p = 0; p < panels.meshes.size(); ++p) {
    panels.meshes[p].name = garment.panels[p];
    panels.meshes[p].material = 1 + fabrics.of_panel[p];  // behind the skin
  }
  std::erase_if(panels.nodes, [](const std::vector<int>& nodes) { return nodes.empty(); });
  std::erase_if(panels.meshes, [](const GltfMesh& mesh) { return mesh.triangles.empty(); });
  return panels;
}

using Edge = std::pair<int, int>;

/// How many triangles each edge of the sewn garment has.
std::map<Edge, int> triangles_of_edges(const DressedGarment& garment) {
  std::map<Edge, int> counts;
  for (const Triangle& triangle : garment.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++counts[std::minmax(triangle[k], triangle[(k + 1) % 3])];
    }
  }
  return counts;
}

/// Adds a copy of a point, moved by `along` its normal, with a normal of its own.
int add_copy(GltfMesh& mesh, int of, const Vec3& moved, const Vec3& normal) {
  mesh.points.emplace_back(mesh.points[of] + moved);
  mesh.normals.push_back(normal);
  const Colour colour = mesh.colours[of];
  mesh.colours.push_back(colour);
  for (std::vector<Vec2>& map : mesh.maps) {
    const Vec2 place = map[of];
    map.push_back(place);
  }
  return static_cast<int>(mesh.points.size()) - 1;
}

/// Makes a surface a sheet with two faces. `nodes`: of its points.
void thicken(GltfMesh& mesh, const std::vector<int>& nodes, const std::map<Edge, int>& edges,
             double thickness) {
  const auto points = static_cast<int>(mesh.points.size());
  const std::vector<Triangle> outer = mesh.triangles;
  // Points stay at the cloth's middle until all copies are made.
  std::vector<Vec3> half;
  for (const Vec3& normal : mesh.normals) half.emplace_back(thickness / 2 * normal);
  for (int i = 0; i < points; ++i) add_copy(mesh, i, -half[i], -mesh.normals[i]);
  for (const Triangle& t : outer) {
    mesh.triangles.push_back({t[0] + points, t[2] + points, t[1] + points});
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k];
      const int b = t[(k + 1) % 3];
      if (edges.at(std::minmax(nodes[a], nodes[b])) != 1) continue;
      const Vec3 along = mesh.points[b] - mesh.points[a];
      const Vec3 away = along.cross(half[a] + half[b]);
      const Vec3 normal = away.norm() > 0 ? Vec3(away.normalized()) : Vec3::UnitY();
      const int outer_a = add_copy(mesh, a, half[a], normal);
      const int outer_b = add_copy(mesh, b, half[b], normal);
      const int inner_a = add_copy(mesh, a, -half[a], normal);
      const int inner_b = add_copy(mesh, b, -half[b], normal);
      mesh.triangles.push_back({inner_a, inner_b, outer_b});
      mesh.triangles.push_back({inner_a, outer_b, outer_a});
    }
  }
  for (int i = 0; i < points; ++i) mesh.points[i] += half[i];
}

}  // namespace

std::string ease_glb(const EaseReport& report, double thickness) {
  GltfScene scene;
  scene.generator = "Toile " + toile_version();
  const std::vector<BarMark> marks = ease_scale(report).bar.marks;
  scene.colours =
      (report.loads ? "ease: orange touches and is stretched, up to " + marks.front().text
                    : std::string("gap")) +
      "; white touches; blue stands off, up to " + fixed_number(1000 * report.top, 0) +
      " mm; black is inside the body";
  scene.materials.push_back({"skin", skin_colour});
  for (const std::string& name : fabrics_of(report).names) scene.materials.push_back({name});
  GltfMesh body;
  body.name = "body";
  body.points = report.body.points;
  body.normals = vertex_normals(report.body.points, report.body.triangles);
  body.triangles = report.body.triangles;
  PanelMeshes panels = panel_meshes(report);
  const std::map<Edge, int> edges = triangles_of_edges(report.garment);
  for (std::size_t p = 0; p < panels.meshes.size(); ++p) {
    if (thickness > 0) thicken(panels.meshes[p], panels.nodes[p], edges, thickness);
  }
  scene.meshes = std::move(panels.meshes);
  scene.meshes.push_back(std::move(body));
  return format_glb(scene);
}

ObjData body_obj(const EaseReport& report) {
  ObjData obj;
  obj.comments = {"Toile body (m)"};
  obj.points = report.body.points;
  obj.normals = vertex_normals(report.body.points, report.body.triangles);
  obj.groups = {"body"};
  obj.materials = {"skin"};
  for (const Triangle& t : report.body.triangles) {
    obj.faces.push_back({{{t[0]}, {t[1]}, {t[2]}}, 0});
  }
  return obj;
}

}  // namespace toile
