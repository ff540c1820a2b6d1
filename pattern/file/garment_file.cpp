#include "pattern/file/garment_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "geometry/half_edges.h"
#include "geometry/vertex_normals.h"
#include "io/json_value.h"
#include "io/obj.h"
#include "io/output_file.h"
#include "io/sidecar.h"
#include "pattern/classify/classify.h"
#include "pattern/classify/panel_class_json.h"
#include "pattern/file/attachment_json.h"
#include "pattern/file/placement_json.h"
#include "pattern/mesh/nesting.h"

namespace toile {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& place, const std::string& problem) {
  throw Error(place, problem, "write both files again with mesh-pattern");
}

constexpr const char* sidecar_kind = "garment";

/// Neither a pattern has both as lists, nor a report of dress.
bool has_panels_and_seams(const JsonValue& root) {
  if (!root.is_object()) return false;
  const auto panels = root.find("panels");
  const auto seams = root.find("seams");
  return panels && panels->is_array() && seams && seams->is_array();
}

}  // namespace

// One panel or seam a line.
std::string garment_json(const PanelMesh& garment) {
  std::string text =
      "{\"garment\": 1, \"unit\": \"m\", \"edge_length\": " + Json(garment.edge_length).dump() +
      ", \"subdivisions\": " + std::to_string(garment.subdivisions) +
      (garment.has_places ? "" : ", \"has_places\": false") + ",\n\"panels\": [";
  const char* separator = "\n";
  for (const MeshedPanel& panel : garment.panels) {
    Json json = {{"name", panel.name},           {"fabric", panel.fabric},
                 {"grain", panel.grain},         {"first_point", panel.first_point},
                 {"points", panel.points},       {"first_triangle", panel.first_triangle},
                 {"triangles", panel.triangles}, {"class", panel_class_json(panel.is)}};
    if (panel.layered) json["layered"] = true;
    if (panel.placement.by_part()) json["placement"] = placement_json(panel.placement);
    text += separator;
    text += json.dump();
    separator = ",\n";
  }
  text += "],\n\"seams\": [";
  separator = "\n";
  for (const MeshedSeam& seam : garment.seams) {
    const Json json = {{"name", seam.name},
                       {"a", seam.a},
                       {"b", seam.b},
                       {"length_a", seam.length_a},
                       {"length_b", seam.length_b}};
    text += separator;
    text += json.dump();
    separator = ",\n";
  }
  text += "]";
  separator = ",\n\"elastics\": [\n";
  for (const MeshedElastic& elastic : garment.elastics) {
    const Json json = {{"name", elastic.name},
                       {"points", elastic.points},
                       {"ratio", elastic.ratio},
                       {"stiffness_N", elastic.stiffness}};
    text += separator + json.dump();
    separator = ",\n";
  }
  if (!garment.elastics.empty()) text += "]";
  separator = ",\n\"attachments\": [\n";
  for (const MeshedAttachment& attached : garment.attachments) {
    nlohmann::ordered_json json = {{"name", attached.name}, {"points", attached.points}};
    json.update(attachment_json(attached.how));
    text += separator + json.dump();
    separator = ",\n";
  }
  if (!garment.attachments.empty()) text += "]";
  separator = ",\n\"marks\": [\n";
  for (const MeshedMark& mark : garment.marks) {
    text += separator + Json({{"name", mark.name}, {"points", mark.points}}).dump();
    separator = ",\n";
  }
  if (!garment.marks.empty()) text += "]";
  separator = ",\n\"cut_outs\": [\n";
  for (const MeshedCutOut& cut_out : garment.cut_outs) {
    text += separator + Json({{"name", cut_out.name}, {"points", cut_out.points}}).dump();
    separator = ",\n";
  }
  return text + (garment.cut_outs.empty() ? "}\n" : "]}\n");
}

namespace {

int count_of(const JsonValue& value) { return value.index(std::numeric_limits<int>::max() / 2); }

std::string text_or(const JsonValue& value, const char* key, const char* otherwise) {
  const auto found = value.find(key);
  return found ? found->text() : otherwise;
}

double number_or(const JsonValue& value, const char* key, double otherwise) {
  const auto found = value.find(key);
  return found ? found->number() : otherwise;
}

/// What files tell that earlier states of mesh-pattern wrote, without a class.
PanelWitnesses witnesses_in(const JsonValue& panel) {
  return {panel.get("name").text(), body_part(text_or(panel, "part", "")),
          text_or(panel, "label", "")};
}

MeshedPanel panel_of(const JsonValue& value) {
  MeshedPanel panel{value.get("name").text(),        text_or(value, "fabric", ""),
                    number_or(value, "grain", 0),    count_of(value.get("first_point")),
                    count_of(value.get("points")),   count_of(value.get("first_triangle")),
                    count_of(value.get("triangles"))};
  if (const auto layered = value.find("layered")) panel.layered = layered->flag();
  if (const auto is = value.find("class")) {
    panel.is = read_panel_class(*is);
  } else {
    panel.is.part = {witnesses_in(value).part, PanelSource::stated};
  }
  if (const auto placement = value.find("placement")) {
    panel.placement = read_placement(*placement, panel.is.part, 1);
  }
  return panel;
}

std::vector<int> points_of(const JsonValue& list, std::size_t points, std::size_t min_count = 2) {
  std::vector<int> along;
  for (std::size_t i = 0; i < list.size(min_count); ++i) {
    along.push_back(list.item(i).index(static_cast<int>(points)));
  }
  return along;
}

MeshedElastic elastic_of(const JsonValue& value, std::size_t points) {
  MeshedElastic elastic{value.get("name").text(), points_of(value.get("points"), points),
                        value.get("ratio").number(), value.get("stiffness_N").number()};
  if (!(elastic.ratio > 0 && elastic.ratio <= 1 && elastic.stiffness > 0)) {
    fail(value.place(), "has no ratio in (0, 1] or no stiffness");
  }
  return elastic;
}

MeshedAttachment attachment_of(const JsonValue& value, std::size_t points) {
  return {value.get("name").text(), points_of(value.get("points"), points, 1),
          read_attachment(value, 1)};
}

/// A length that the mesh shows, too. Throws Error where the two are of different garments: the
/// drape would go by it without a word. Meshes differ by up to 3 from what is asked, curves from
/// their chords by up to 2. Ten lets both pass; half and double would, too.
double length_like(const JsonValue& value, double in_mesh) {
  constexpr double most = 10;
  const double length = value.number();
  if (!(length > in_mesh / most && length < in_mesh * most)) {
    fail(value.place(), number_text(length) + " m does not fit the mesh, which has " +
                            number_text(in_mesh, 2) + " m there");
  }
  return length;
}

double mean_edge(const PanelMesh& garment) {
  double sum = 0;
  for (const Triangle& t : garment.triangles) {
    for (int i = 0; i < 3; ++i) sum += (garment.flat[t[i]] - garment.flat[t[(i + 1) % 3]]).norm();
  }
  return sum / (3 * static_cast<double>(garment.triangles.size()));
}

double length_along(const PanelMesh& garment, const std::vector<int>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (garment.flat[points[i]] - garment.flat[points[i - 1]]).norm();
  }
  return length;
}

MeshedSeam seam_of(const JsonValue& value, const PanelMesh& garment) {
  const std::size_t points = garment.flat.size();
  MeshedSeam seam;
  seam.name = value.get("name").text();
  seam.a = points_of(value.get("a"), points);
  seam.b = points_of(value.get("b"), points);
  if (seam.a.size() != seam.b.size()) {
    fail(value.place(), "has sides of " + std::to_string(seam.a.size()) + " and " +
                            std::to_string(seam.b.size()) + " points");
  }
  seam.length_a = length_like(value.get("length_a"), length_along(garment, seam.a));
  seam.length_b = length_like(value.get("length_b"), length_along(garment, seam.b));
  return seam;
}

/// Points, flat coordinates and triangles of an OBJ whose corners each pair one v with one vt.
void read_mesh(const ObjData& data, const std::string& name, PanelMesh& garment) {
  garment.placed = data.points;
  std::vector<int> texture_of(data.points.size(), -1);
  for (std::size_t f = 0; f < data.faces.size(); ++f) {
    const ObjFace& face = data.faces[f];
    const std::string where = "face " + std::to_string(f);
    if (face.corners.size() != 3) fail(name, where + " is no triangle");
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const ObjCorner& corner = face.corners[k];
      if (corner.texture < 0) fail(name, where + " has no flat coordinates (vt)");
      int& texture = texture_of[corner.point];
      if (texture >= 0 && data.texture[texture] != data.texture[corner.texture]) {
        fail(name, "vertex " + std::to_string(corner.point + 1) +
                       " has two flat coordinates, so panels already share it");
      }
      texture = corner.texture;
      triangle[k] = corner.point;
    }
    garment.triangles.push_back(triangle);
  }
  garment.flat.reserve(data.points.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    if (texture_of[i] < 0) fail(name, "vertex " + std::to_string(i + 1) + " is in no face");
    garment.flat.push_back(data.texture[texture_of[i]]);
  }
}

void check_turned(const PanelMesh& garment, const std::string& name) {
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    const auto& [a, b, c] = garment.triangles[t];
    const Vec2 u = garment.flat[b] - garment.flat[a];
    const Vec2 v = garment.flat[c] - garment.flat[a];
    if (!(u.x() * v.y() - u.y() * v.x() > 0)) {
      fail(name, "face " + std::to_string(t) + " is not counter-clockwise in flat coordinates");
    }
  }
}

/// Throws Error when two triangles of a flat panel lie on each other. No triangle of a flat panel
/// is turned over, so two that pass an edge in the same direction overlap there.
void check_overlaps(const PanelMesh& garment, const std::string& name) {
  const std::vector<HalfEdge> edges = half_edges(garment.triangles, garment.flat.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].same_edge(edges[i]); ++j) {
      if (edges[j].forward != edges[i].forward) continue;
      fail(name, "faces " + std::to_string(edges[i].triangle) + " and " +
                     std::to_string(edges[j].triangle) + " lie on each other in the flat panel");
    }
  }
}

/// Throws Error for a panel that is placed crushed: nothing could unfold it. A panel may be placed
/// bent, or a little out of shape.
void check_placed(const PanelMesh& garment, const std::string& name) {
  constexpr double min_share = 0.01;
  for (const MeshedPanel& panel : garment.panels) {
    double flat = 0;
    double placed = 0;
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      const auto& [a, b, c] = garment.triangles[t];
      const Vec2 u = garment.flat[b] - garment.flat[a];
      const Vec2 v = garment.flat[c] - garment.flat[a];
      const Vec3 along = garment.placed[b] - garment.placed[a];
      flat += u.x() * v.y() - u.y() * v.x();
      placed += along.cross(garment.placed[c] - garment.placed[a]).norm();
    }
    if (placed > min_share * flat) continue;
    fail(name, "panel '" + panel.name + "' is placed with less than a hundredth of its area");
  }
}

/// Throws Error unless the panels' ranges follow one another, cover everything, and hold their own
/// triangles.
void check_ranges(const PanelMesh& garment, const std::string& name) {
  std::int64_t point = 0;
  std::int64_t triangle = 0;
  for (const MeshedPanel& panel : garment.panels) {
    const std::string where = "panel '" + panel.name + "'";
    if (panel.first_point != point || panel.first_triangle != triangle || panel.points < 3 ||
        panel.triangles < 1) {
      fail(name, where + " has ranges that do not follow the panel before it");
    }
    point += panel.points;
    triangle += panel.triangles;
    if (point > static_cast<std::int64_t>(garment.flat.size()) ||
        triangle > static_cast<std::int64_t>(garment.triangles.size())) {
      fail(name, where + " has more points or triangles than the OBJ file");
    }
    for (std::int64_t t = panel.first_triangle; t < triangle; ++t) {
      for (const int corner : garment.triangles[static_cast<std::size_t>(t)]) {
        if (corner >= panel.first_point && corner < point) continue;
        fail(name, where + " has a triangle (" + std::to_string(t) + ") that leaves its points");
      }
    }
  }
  if (point != static_cast<std::int64_t>(garment.flat.size()) ||
      triangle != static_cast<std::int64_t>(garment.triangles.size())) {
    fail(name, "covers " + std::to_string(point) + " points and " + std::to_string(triangle) +
                   " triangles, but the OBJ file has " + std::to_string(garment.flat.size()) +
                   " and " + std::to_string(garment.triangles.size()));
  }
}

}  // namespace

fs::path garment_json_path(const fs::path& obj) { return sidecar_path(obj, sidecar_kind); }

fs::path garment_json_beside(const fs::path& obj) {
  return sidecar_beside(obj, sidecar_kind, has_panels_and_seams);
}

void write_garment(const OutputPath& obj, const PanelMesh& garment) {
  ObjData data;
  data.comments = {"Toile garment: v placed points, vt flat pattern coordinates (m), l stitches"};
  data.points = garment.placed;
  data.texture = garment.flat;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const MeshedPanel& panel = garment.panels[p];
    data.groups.push_back(panel.name);
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      ObjFace face;
      face.group = static_cast<int>(p);
      for (const int corner : garment.triangles[t]) face.corners.push_back({corner, corner});
      data.faces.push_back(std::move(face));
    }
  }
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      if (seam.a[i] != seam.b[i]) data.lines.push_back({seam.a[i], seam.b[i]});
    }
  }
  OutputFiles pair;
  OutputFiles& files = obj.files() != nullptr ? *obj.files() : pair;
  write_obj(files.at(obj.path()), data);
  write_file(files.at(garment_json_path(obj.path())), garment_json(garment));
  pair.commit();
}

PanelMesh read_garment(const fs::path& obj, const fs::path& json,
                       std::vector<std::string>* warnings) {
  PanelMesh garment;
  read_mesh(read_obj(obj, max_metres), obj.string(), garment);
  const fs::path path = json.empty() ? garment_json_beside(obj) : json;
  if (json.empty() && !fs::exists(path)) {
    fail(path.string(), "is missing: it holds the panels and seams of " + obj.string());
  }
  return parse_garment(std::move(garment), obj.string(), read_file(path), path.string(), warnings);
}

PanelMesh parse_garment(PanelMesh garment, const std::string& mesh_name, const std::string& json,
                        const std::string& name, std::vector<std::string>* warnings) {
  check_turned(garment, mesh_name);
  check_overlaps(garment, mesh_name);
  const JsonDocument document(json, name);
  const JsonValue root = document.root();
  if (const auto subdivisions = root.find("subdivisions")) {
    garment.subdivisions = subdivisions->index();
  }
  if (const auto has_places = root.find("has_places")) garment.has_places = has_places->flag();
  const JsonValue panels = root.get("panels");
  std::vector<PanelWitnesses> told;
  bool has_classes = true;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const JsonValue panel = panels.item(i).called(name + ": panel " + std::to_string(i));
    garment.panels.push_back(panel_of(panel));
    told.push_back(witnesses_in(panel));
    has_classes = has_classes && panel.find("class").has_value();
  }
  check_ranges(garment, name);
  check_placed(garment, mesh_name);
  if (const auto edge_length = root.find("edge_length");
      edge_length && edge_length->number() != 0) {
    garment.edge_length = length_like(*edge_length, mean_edge(garment));
  }
  const JsonValue seams = root.get("seams");
  for (std::size_t i = 0; i < seams.size(); ++i) {
    garment.seams.push_back(
        seam_of(seams.item(i).called(name + ": seam " + std::to_string(i)), garment));
  }
  if (!has_classes) classify(garment, told);
  if (const auto elastics = root.find("elastics")) {
    for (std::size_t i = 0; i < elastics->size(); ++i) {
      garment.elastics.push_back(elastic_of(
          elastics->item(i).called(name + ": elastic " + std::to_string(i)), garment.flat.size()));
    }
  }
  if (const auto attachments = root.find("attachments")) {
    for (std::size_t i = 0; i < attachments->size(); ++i) {
      const JsonValue value =
          attachments->item(i).called(name + ": attachment " + std::to_string(i));
      // Earlier states of mesh-pattern wrote these for edges that were merged.
      if (value.get("points").size() == 0) {
        if (warnings != nullptr) {
          warnings->push_back(value.place() + " (" + value.get("name").text() +
                              ") has no points and is left out; mesh the pattern again");
        }
        continue;
      }
      garment.attachments.push_back(attachment_of(value, garment.flat.size()));
    }
  }
  if (const auto marks = root.find("marks")) {
    for (std::size_t i = 0; i < marks->size(); ++i) {
      const JsonValue mark = marks->item(i).called(name + ": mark " + std::to_string(i));
      garment.marks.push_back(
          {mark.get("name").text(), points_of(mark.get("points"), garment.flat.size(), 1)});
    }
  }
  if (const auto cut_outs = root.find("cut_outs")) {
    for (std::size_t i = 0; i < cut_outs->size(); ++i) {
      const JsonValue hole = cut_outs->item(i).called(name + ": cut-out " + std::to_string(i));
      garment.cut_outs.push_back(
          {hole.get("name").text(), points_of(hole.get("points"), garment.flat.size(), 3)});
    }
  }
  if (const auto problem = nesting_problem(garment)) fail(name, *problem);
  return garment;
}

namespace {

/// Throws Error when two faces have the same flat corners. Borders and edges would be counted
/// wrong.
void refuse_doubled_faces(const DressedGarment& garment, const std::string& name) {
  std::map<Triangle, std::size_t> face_of;
  for (std::size_t f = 0; f < garment.flat_triangles.size(); ++f) {
    Triangle corners = garment.flat_triangles[f];
    std::sort(corners.begin(), corners.end());
    const auto [found, added] = face_of.try_emplace(corners, f);
    if (added) continue;
    throw Error(
        name, "face " + std::to_string(f) + " is face " + std::to_string(found->second) + " again",
        "use the dressed.obj that dress wrote");
  }
}

}  // namespace

std::string format_dressed(const DressedGarment& garment) {
  ObjData data;
  data.comments = {"Toile dressed garment: v nodes (sewn points shared), vt flat coordinates (m)"};
  data.points = garment.points;
  data.texture = garment.flat;
  data.normals = vertex_normals(garment.points, garment.triangles);
  data.groups = garment.panels;
  data.materials = garment.fabrics;
  data.materials.resize(garment.panels.size());
  for (std::string& material : data.materials) {
    if (material.empty()) material = "cloth";
  }
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    ObjFace face;
    face.group = garment.panel_of_triangle.at(t);
    for (std::size_t k = 0; k < 3; ++k) {
      face.corners.push_back({garment.triangles[t][k], garment.flat_triangles.at(t)[k]});
    }
    data.faces.push_back(std::move(face));
  }
  return format_obj(data);
}

void write_dressed(const OutputPath& obj, const DressedGarment& garment) {
  write_file(obj, format_dressed(garment));
}

DressedGarment read_dressed(const fs::path& obj) {
  const std::string name = obj.string();
  ObjData data = read_obj(obj, max_metres);
  if (data.faces.empty()) throw Error(name, "holds no face", "is it a dressed garment?");
  DressedGarment garment;
  for (std::size_t f = 0; f < data.faces.size(); ++f) {
    const ObjFace& face = data.faces[f];
    const std::string where = "face " + std::to_string(f);
    const char* remedy = "use the dressed.obj that dress wrote";
    if (face.corners.size() != 3) throw Error(name, where + " is no triangle", remedy);
    if (face.group < 0) throw Error(name, where + " belongs to no panel (g)", remedy);
    Triangle nodes{};
    Triangle flat{};
    for (std::size_t k = 0; k < 3; ++k) {
      nodes[k] = face.corners[k].point;
      flat[k] = face.corners[k].texture;
      if (flat[k] < 0) throw Error(name, where + " has no flat coordinates (vt)", remedy);
    }
    garment.triangles.push_back(nodes);
    garment.flat_triangles.push_back(flat);
    garment.panel_of_triangle.push_back(face.group);
  }
  garment.points = std::move(data.points);
  garment.flat = std::move(data.texture);
  garment.panels = std::move(data.groups);
  refuse_doubled_faces(garment, name);
  return garment;
}

}  // namespace toile
