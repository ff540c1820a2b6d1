#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/angles.h"
#include "io/text.h"
#include "pattern/import/imported_pattern.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// A number with so many decimals; -0 becomes 0.
double rounded(double value, double digits) { return std::round(value * digits) / digits + 0.0; }

/// Metres as centimetres, to a hundred-thousandth of a millimetre.
Json to_centimetres(const Vec2& point) {
  return {rounded(point.x() * 100, 1e6), rounded(point.y() * 100, 1e6)};
}

Json to_centimetres(const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (const Vec2& point : points) list.push_back(to_centimetres(point));
  return list;
}

Json degrees(double radians) { return rounded(to_degrees(radians), 1e4); }

Json edge_json(const EdgedOutline& outline, const OutlineEdge& edge) {
  Json json = {{"endpoints", {edge.from, edge.to}}};
  if (edge.curves.size() == 1 && edge.curves[0].straight) return json;
  const Vec2& start = outline.vertices[static_cast<std::size_t>(edge.from)];
  const Vec2 along = outline.vertices[static_cast<std::size_t>(edge.to)] - start;
  const Vec2 left(-along.y(), along.x());
  const auto relative = [&](const Vec2& point) -> Json {
    const Vec2 arm = point - start;
    return {rounded(arm.dot(along) / along.squaredNorm(), 1e9),
            rounded(arm.dot(left) / along.squaredNorm(), 1e9)};
  };
  Json params = Json::array();
  for (std::size_t i = 0; i < edge.curves.size(); ++i) {
    const auto& points = edge.curves[i].points;
    if (i > 0) params.push_back(relative(points[0]));
    params.push_back(relative(points[1]));
    params.push_back(relative(points[2]));
  }
  json["curvature"] = {{"type", edge.curves.size() == 1 ? "cubic" : "cubics"}, {"params", params}};
  return json;
}

Json stitch_json(const ImportedPattern& pattern, const ImportedSeam& seam) {
  const auto side = [&](int panel, int edge) -> Json {
    return {{"panel", pattern.panels[static_cast<std::size_t>(panel)].name}, {"edge", edge}};
  };
  Json stitch = {side(seam.panel_a, seam.edge_a), side(seam.panel_b, seam.edge_b)};
  Json how = Json::object();
  if (seam.text.direction == StitchDirection::by_position) {
    how["reversed"] = "found";
  } else if (!seam.end_to_start || seam.text.layered) {
    how["reversed"] = seam.end_to_start;
  }
  if (seam.text.gathered && seam.text.fullness > 0) {
    how["gather"] = seam.text.fullness;
  } else if (seam.text.gathered) {
    how["gather"] = true;
  }
  if (seam.text.layered) how["layer"] = true;
  if (!how.empty()) stitch.push_back(std::move(how));
  return stitch;
}

}  // namespace

nlohmann::ordered_json pattern_json(const ImportedPattern& pattern) {
  Json panels = Json::object();
  Json order = Json::array();
  for (const ImportedPanel& panel : pattern.panels) {
    Json json;
    json["vertices"] = to_centimetres(panel.outline.vertices);
    json["edges"] = Json::array();
    for (const OutlineEdge& edge : panel.outline.edges) {
      json["edges"].push_back(edge_json(panel.outline, edge));
    }
    if (panel.grain) json["grain"] = degrees(*panel.grain);
    if (!panel.fabric.empty()) json["fabric"] = panel.fabric;
    if (!panel.material.empty()) json["material"] = valid_utf8(panel.material);
    if (panel.quantity != 1) json["quantity"] = panel.quantity;
    if (!panel.left_out.empty()) json["left_out"] = valid_utf8(panel.left_out);
    if (panel.is_of_pair) json["side"] = "unknown";
    for (const OutlineNotch& notch : panel.outline.notches) {
      Json entry = {{"vertex", notch.vertex}};
      if (notch.angle) entry["angle"] = degrees(*notch.angle);
      json["notches"].push_back(entry);
    }
    for (const auto& line : panel.internal_lines)
      json["internal_lines"].push_back(to_centimetres(line));
    for (const auto& loop : panel.cut_outs) json["cut_outs"].push_back(to_centimetres(loop));
    if (!panel.drill_holes.empty()) json["drill_holes"] = to_centimetres(panel.drill_holes);
    panels[panel.name] = std::move(json);
    order.push_back(panel.name);
  }
  Json stitches = Json::array();
  for (const ImportedSeam& seam : pattern.seams) stitches.push_back(stitch_json(pattern, seam));
  Json result;
  result["pattern"] = {{"panels", std::move(panels)},
                       {"panel_order", std::move(order)},
                       {"stitches", std::move(stitches)}};
  result["properties"] = {{"curvature_coords", "relative"},
                          {"normalize_panel_translation", false},
                          {"normalized_edge_loops", true},
                          {"up", "unknown"},
                          {"units_in_meter", 100}};
  return result;
}

namespace {

void append_readable(std::string& text, const Json& json, std::size_t indent) {
  constexpr std::size_t width = 96;
  const std::string line = json.dump();
  if (!json.is_structured() || indent + line.size() <= width || json.empty()) {
    text += line;
    return;
  }
  const std::string margin(indent + 1, ' ');
  text += json.is_array() ? '[' : '{';
  bool first = true;
  for (const auto& item : json.items()) {
    text += (first ? "\n" : ",\n") + margin;
    first = false;
    if (json.is_object()) text += Json(item.key()).dump() + ": ";
    append_readable(text, item.value(), indent + 1);
  }
  text += "\n" + std::string(indent, ' ');
  text += json.is_array() ? ']' : '}';
}

}  // namespace

std::string readable_json(const nlohmann::ordered_json& json) {
  std::string text;
  append_readable(text, json, 0);
  return text + "\n";
}

}  // namespace toile
