#include "pattern/pattern_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "geometry/body/skeleton.h"
#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// Coordinates beyond this (metres) are no garment.
constexpr double largest_coordinate = 1000;

/// A radius too short for its chord by more than this share is worth a note.
constexpr double radius_tolerance = 1e-3;

constexpr double degree = std::numbers::pi / 180;

std::string in_quotes(const std::string& text) { return "'" + text + "'"; }

/// Line and column of a byte, both from 1.
std::string line_and_column(const std::string& text, std::size_t byte) {
  byte = std::min(byte, text.size());
  const auto line =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(byte), '\n');
  const std::size_t start = byte == 0 ? std::string::npos : text.rfind('\n', byte - 1);
  const std::size_t column = start == std::string::npos ? byte : byte - start - 1;
  return std::to_string(line + 1) + ":" + std::to_string(std::max<std::size_t>(column, 1));
}

/// A JSON value that knows where it stands, and takes nothing on trust.
struct Value {
  const Json& json;
  std::string place;

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = "") const {
    throw Error(place, problem, remedy);
  }

  std::optional<Value> find(const std::string& key) const {
    if (!json.is_object()) fail("is not an object");
    const auto found = json.find(key);
    if (found == json.end() || found->is_null()) return std::nullopt;
    return Value{*found, place + ", " + key};
  }
  Value get(const std::string& key) const {
    auto value = find(key);
    if (!value) fail("has no " + in_quotes(key));
    return *value;
  }
  Value item(std::size_t i) const { return {json.at(i), place + "[" + std::to_string(i) + "]"}; }

  std::size_t array(std::size_t least, std::size_t most) const {
    if (!json.is_array() || json.size() < least || json.size() > most) {
      fail("is not a list of " + std::to_string(least) +
           (most == least ? ""
            : most > 1000 ? " or more"
                          : " to " + std::to_string(most)) +
           " entries");
    }
    return json.size();
  }
  double number() const {
    if (!json.is_number()) fail("is not a number");
    const double value = json.get<double>();
    if (!std::isfinite(value)) fail("is not a finite number");
    return value;
  }
  int index() const {
    if (!json.is_number_integer()) fail("is not a whole number");
    const auto value = json.get<std::int64_t>();
    if (value < 0 || value > 1000000) fail("is out of range");
    return static_cast<int>(value);
  }
  bool flag() const {
    if (json.is_boolean()) return json.get<bool>();
    return number() != 0;
  }
  std::string text() const {
    if (!json.is_string()) fail("is not text");
    return json.get<std::string>();
  }
  Vec2 pair() const {
    array(2, 2);
    return {item(0).number(), item(1).number()};
  }
  Vec3 triple() const {
    array(3, 3);
    return {item(0).number(), item(1).number(), item(2).number()};
  }
};

class Reader {
 public:
  Reader(const std::string& name, std::vector<Remark>& remarks) : remarks_(remarks) {
    pattern_.source = name;
  }

  Pattern read(const Json& json) {
    const Value top{json, pattern_.source};
    if (!json.is_object() || !top.find("pattern")) {
      top.fail("has no 'pattern'", "is it a GarmentCode pattern specification?");
    }
    unread(top, {"pattern", "properties", "parameters", "parameter_order", "parameter_constraints",
                 "constraints", "constraint_order"});
    properties(top);
    const Value content{*json.find("pattern"), pattern_.source};
    if (!content.json.is_object()) content.fail("'pattern' is not an object");
    unread(content, {"panels", "panel_order", "stitches"});
    panels(content);
    if (const auto stitches = content.find("stitches")) {
      const std::size_t count = stitches->array(0, 100000);
      for (std::size_t i = 0; i < count; ++i) {
        stitch({stitches->item(i).json, pattern_.source + ": stitch " + std::to_string(i)});
      }
    }
    return std::move(pattern_);
  }

 private:
  void note(const std::string& text) { remarks_.push_back({false, text}); }

  void unread(const Value& value, const std::vector<std::string>& known) {
    for (const auto& [key, ignored] : value.json.items()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        note(value.place + ": key " + in_quotes(key) + " is not read");
      }
    }
  }

  void properties(const Value& top) {
    const auto given = top.find("properties");
    if (!given) {
      note(pattern_.source + ": no 'properties'; lengths are taken as centimetres");
      return;
    }
    unread(*given, {"curvature_coords", "normalize_panel_translation", "normalized_edge_loops",
                    "units_in_meter", "original_units_in_meter"});
    if (const auto units = given->find("units_in_meter")) {
      const double value = units->number();
      if (value < 1e-3 || value > 1e6) units->fail("is no sensible number of units");
      unit_ = 1 / value;
    } else {
      note(pattern_.source + ": no 'units_in_meter'; lengths are taken as centimetres");
    }
    if (const auto coordinates = given->find("curvature_coords")) {
      const std::string kind = coordinates->text();
      if (kind != "relative" && kind != "absolute") {
        coordinates->fail(in_quotes(kind) + " is unknown", "use 'relative' or 'absolute'");
      }
      absolute_ = kind == "absolute";
    }
    if (const auto normalize = given->find("normalize_panel_translation")) {
      centre_panels_ = normalize->flag();
    }
  }

  void panels(const Value& content) {
    const Value list = content.get("panels");
    if (!list.json.is_object() || list.json.empty()) list.fail("holds no panel");
    std::vector<std::string> names;
    if (const auto order = content.find("panel_order")) {
      for (std::size_t i = 0; i < order->array(0, 100000); ++i) {
        const std::string name = order->item(i).text();
        if (list.json.contains(name) &&
            std::find(names.begin(), names.end(), name) == names.end()) {
          names.push_back(name);
        }
      }
    }
    for (const auto& [name, ignored] : list.json.items()) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    for (const std::string& name : names) {
      const bool printable = !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' || c == '#' || c == '\\';
      });
      if (!printable || name.front() == ' ' || name.back() == ' ') {
        list.fail("a panel is named " + in_quotes(name), "give it a name of letters and digits");
      }
      panel(name, {*list.json.find(name), pattern_.source + ": panel " + in_quotes(name)});
    }
  }

  Vec2 metres(const Value& pair) const {
    const Vec2 value = pair.pair() * unit_;
    if (value.cwiseAbs().maxCoeff() > largest_coordinate) {
      pair.fail("lies more than a kilometre away", "check 'units_in_meter'");
    }
    return value;
  }

  void panel(const std::string& name, const Value& value) {
    if (!value.json.is_object()) value.fail("is not an object");
    unread(value, {"translation", "rotation", "vertices", "edges", "label", "placement", "grain",
                   "fabric"});
    PatternPanel panel;
    panel.name = name;
    if (const auto translation = value.find("translation")) {
      panel.translation = translation->triple() * unit_;
      if (panel.translation.cwiseAbs().maxCoeff() > largest_coordinate) {
        translation->fail("is more than a kilometre", "check 'units_in_meter'");
      }
    }
    if (const auto rotation = value.find("rotation")) {
      const Vec3 angles = rotation->triple() * degree;
      panel.rotation = (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) *
                        Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                        Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
                           .toRotationMatrix();
    }
    if (const auto grain = value.find("grain")) panel.grain = grain->number() * degree;
    if (const auto fabric = value.find("fabric")) panel.fabric = fabric->text();
    if (const auto placement = value.find("placement")) {
      unread(*placement, {"part"});
      if (const auto part = placement->find("part")) panel.part = body_part(*part);
    }

    const Value vertices = value.get("vertices");
    const std::size_t count = vertices.array(2, 100000);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(metres(vertices.item(i)));
    if (centre_panels_) {
      Vec2 centre = Vec2::Zero();
      for (const Vec2& point : points) centre += point / static_cast<double>(count);
      for (Vec2& point : points) point -= centre;
      panel.translation += Vec3(centre.x(), centre.y(), 0);
      offset_ = centre;
    }
    edges(panel, value.get("edges"), points);
    pattern_.panels.push_back(std::move(panel));
  }

  static std::string body_part(const Value& part) {
    const std::string name = part.text();
    if (std::find(body_parts.begin(), body_parts.end(), name) == body_parts.end()) {
      std::string known;
      for (const auto& body_part : body_parts)
        known += (known.empty() ? "" : ", ") + std::string(body_part);
      part.fail(in_quotes(name) + " is no body part", "use one of " + known);
    }
    return name;
  }

  void edges(PatternPanel& panel, const Value& list, const std::vector<Vec2>& points) {
    const std::string place = pattern_.source + ": panel " + in_quotes(panel.name);
    const std::size_t count = list.array(2, 100000);
    std::vector<std::array<int, 2>> ends;
    for (std::size_t i = 0; i < count; ++i) {
      const Value edge{list.item(i).json, place + ", edge " + std::to_string(i)};
      if (!edge.json.is_object()) edge.fail("is not an object");
      unread(edge, {"endpoints", "curvature", "label"});
      const Value endpoints = edge.get("endpoints");
      endpoints.array(2, 2);
      std::array<int, 2> pair{};
      for (std::size_t k = 0; k < 2; ++k) {
        pair[k] = endpoints.item(k).index();
        if (pair[k] >= static_cast<int>(points.size())) {
          edge.fail("names vertex " + std::to_string(pair[k]) + ", but the panel has " +
                    std::to_string(points.size()));
        }
      }
      if (pair[0] == pair[1]) edge.fail("starts and ends at the same vertex", "split it in two");
      ends.push_back(pair);
      PatternEdge read{curve(edge, points[static_cast<std::size_t>(pair[0])],
                             points[static_cast<std::size_t>(pair[1])]),
                       ""};
      if (const auto label = edge.find("label")) read.label = label->text();
      panel.edges.push_back(std::move(read));
    }
    panel.outline = loop(place, ends);
  }

  /// Walks the edges from the first one into one closed loop.
  static std::vector<OutlineStep> loop(const std::string& place,
                                       const std::vector<std::array<int, 2>>& ends) {
    std::map<int, std::vector<int>> at_vertex;
    for (std::size_t e = 0; e < ends.size(); ++e) {
      for (const int vertex : ends[e]) at_vertex[vertex].push_back(static_cast<int>(e));
    }
    for (const auto& [vertex, meeting] : at_vertex) {
      if (meeting.size() == 2) continue;
      throw Error(
          place + ", edge " + std::to_string(meeting.front()),
          std::to_string(meeting.size()) + " edges meet at vertex " + std::to_string(vertex),
          "an outline is one closed loop, two edges at each of its vertices");
    }
    std::vector<OutlineStep> steps;
    int edge = 0;
    int vertex = ends[0][0];
    do {
      const auto& pair = ends[static_cast<std::size_t>(edge)];
      const bool forward = pair[0] == vertex;
      steps.push_back({edge, forward});
      vertex = forward ? pair[1] : pair[0];
      const auto& meeting = at_vertex[vertex];
      edge = meeting[0] == edge ? meeting[1] : meeting[0];
    } while (edge != 0 && steps.size() <= ends.size());
    if (steps.size() != ends.size()) {
      std::vector<bool> walked(ends.size(), false);
      for (const OutlineStep& step : steps) walked[static_cast<std::size_t>(step.edge)] = true;
      const auto missed = std::find(walked.begin(), walked.end(), false) - walked.begin();
      throw Error(place + ", edge " + std::to_string(missed), "belongs to a second loop",
                  "a panel has one outline; holes are not read");
    }
    return steps;
  }

  EdgeCurve curve(const Value& edge, const Vec2& start, const Vec2& end) {
    const auto curvature = edge.find("curvature");
    if (!curvature) return EdgeCurve::line(start, end);
    // The first generation of the format knew one kind of curve: a lone quadratic control point.
    if (curvature->json.is_array()) {
      return EdgeCurve::quadratic(start, control(*curvature, start, end), end);
    }
    unread(*curvature, {"type", "params"});
    const Value type = curvature->get("type");
    const std::string kind = type.text();
    const Value params = curvature->get("params");
    if (kind == "quadratic") {
      params.array(1, 1);
      return EdgeCurve::quadratic(start, control(params.item(0), start, end), end);
    }
    if (kind == "cubic") {
      params.array(2, 2);
      return EdgeCurve::cubic(start, control(params.item(0), start, end),
                              control(params.item(1), start, end), end);
    }
    if (kind != "circle") {
      type.fail(in_quotes(kind) + " is unknown", "use quadratic, cubic or circle");
    }
    params.array(3, 3);
    const double radius = params.item(0).number() * unit_;
    if (!(radius > 0) || radius > 1e6) params.item(0).fail("is no radius");
    const double half = (end - start).norm() / 2;
    if (radius < half * (1 - radius_tolerance)) {
      note(edge.place + ": the circle's radius is too short to reach; half the chord is taken");
    }
    return EdgeCurve::arc(start, end, radius, params.item(1).flag(), params.item(2).flag());
  }

  /// A control point: in the frame of the edge (start at 0, end at (1, 0), y to its left), or in
  /// the panel's drawing.
  Vec2 control(const Value& value, const Vec2& start, const Vec2& end) const {
    if (absolute_) return metres(value) - offset_;
    const Vec2 relative = value.pair();
    const Vec2 run = end - start;
    const Vec2 point = start + relative.x() * run + relative.y() * Vec2(-run.y(), run.x());
    if (!(point.cwiseAbs().maxCoeff() <= largest_coordinate)) value.fail("lies too far away");
    return point;
  }

  EdgeRef side(const Value& stitch, std::size_t which) const {
    const Value value{stitch.json.at(which), stitch.place + ", side " + std::to_string(which)};
    const std::string name = value.get("panel").text();
    const int edge = value.get("edge").index();
    const auto found = std::find_if(pattern_.panels.begin(), pattern_.panels.end(),
                                    [&](const PatternPanel& panel) { return panel.name == name; });
    if (found == pattern_.panels.end()) {
      stitch.fail("names panel " + in_quotes(name) + " (edge " + std::to_string(edge) +
                      "), which the pattern does not have",
                  "correct the name or remove the stitch");
    }
    if (edge >= static_cast<int>(found->edges.size())) {
      stitch.fail("names edge " + std::to_string(edge) + " of panel " + in_quotes(name) +
                      ", which has edges 0 to " + std::to_string(found->edges.size() - 1),
                  "correct the edge or remove the stitch");
    }
    return {static_cast<int>(found - pattern_.panels.begin()), edge};
  }

  void stitch(const Value& value) {
    value.array(2, 3);
    Stitch stitch;
    stitch.a = side(value, 0);
    stitch.b = side(value, 1);
    for (std::size_t which = 0; which < 2; ++which) {
      unread({value.json.at(which), value.place + ", side " + std::to_string(which)},
             {"panel", "edge"});
    }
    if (value.json.size() == 3) {
      const Value extra = value.item(2);
      if (extra.json.is_string()) {
        // GarmentCode's word for an edge sewn with its wrong side out.
        if (extra.text() != "right_wrong") extra.fail(in_quotes(extra.text()) + " is unknown");
        stitch.direction = StitchDirection::start_to_start;
      } else {
        if (!extra.json.is_object()) extra.fail("is neither 'right_wrong' nor an object");
        unread(extra, {"name", "reversed"});
        if (const auto name = extra.find("name")) stitch.name = name->text();
        if (const auto reversed = extra.find("reversed")) {
          stitch.direction =
              reversed->flag() ? StitchDirection::end_to_start : StitchDirection::start_to_start;
        }
      }
    }
    pattern_.stitches.push_back(std::move(stitch));
  }

  std::vector<Remark>& remarks_;
  Pattern pattern_;
  double unit_ = 0.01;
  bool absolute_ = false;
  bool centre_panels_ = false;
  Vec2 offset_ = Vec2::Zero();
};

}  // namespace

std::string edge_name(const Pattern& pattern, const EdgeRef& ref) {
  return "panel " + in_quotes(pattern.panels.at(static_cast<std::size_t>(ref.panel)).name) +
         ", edge " + std::to_string(ref.edge);
}

Pattern parse_pattern(const std::string& text, const std::string& name,
                      std::vector<Remark>& remarks) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw Error(name + ":" + line_and_column(text, error.byte), "is not JSON here",
                "look for a missing or extra comma, quote or bracket at or before this place");
  } catch (const Json::exception& error) {
    throw Error(name, std::string("is not JSON (") + error.what() + ")", "");
  }
  return Reader(name, remarks).read(json);
}

Pattern read_pattern(const std::filesystem::path& path, std::vector<Remark>& remarks) {
  return parse_pattern(read_file(path), path.string(), remarks);
}

}  // namespace toile
