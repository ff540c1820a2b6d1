#include "pattern/pattern_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "io/json_value.h"
#include "io/json_words.h"
#include "io/limits.h"
#include "io/output_file.h"
#include "pattern/attachment_json.h"
#include "pattern/constants.h"
#include "pattern/placement_json.h"
#include "pattern/schematic_figure.h"
#include "pattern/seam_order.h"
#include "pattern/sharp_corners.h"
#include "pattern/short_edges.h"

namespace toile {

namespace {

Vec2 pair(const JsonValue& value) {
  value.size(2, 2);
  return {value.item(0).number(), value.item(1).number()};
}

Vec3 triple(const JsonValue& value) {
  value.size(3, 3);
  return {value.item(0).number(), value.item(1).number(), value.item(2).number()};
}

class Reader {
 public:
  Reader(const std::string& name, std::vector<Remark>& remarks) : remarks_(remarks) {
    pattern_.source = name;
  }

  Pattern read(const JsonValue& top) {
    if (!top.is_object() || !top.find("pattern")) {
      top.fail("has no 'pattern'", "is it a GarmentCode pattern specification?");
    }
    unread(top, {"pattern", "properties", "parameters", "parameter_order", "parameter_constraints",
                 "constraints", "constraint_order"});
    properties(top);
    const JsonValue content = top.get("pattern");
    unread(content, {"panels", "panel_order", "stitches"});
    panels(content);
    if (const auto stitches = content.find("stitches")) {
      refuse_more(*stitches, stitches->size(), max_stitches, "stitches");
      for (std::size_t i = 0; i < stitches->size(); ++i) {
        stitch(stitches->item(i).called(pattern_.source + ": stitch " + std::to_string(i)));
      }
    }
    return std::move(pattern_);
  }

 private:
  void note(const std::string& text) { remarks_.push_back({false, text}); }

  static void refuse_more(const JsonValue& list, std::size_t count, int max,
                          const std::string& what) {
    if (count <= static_cast<std::size_t>(max)) return;
    list.fail("has " + std::to_string(count) + " " + what + ", more than " + std::to_string(max),
              "is it really a garment? join short edges to curves");
  }

  void unread(const JsonValue& value, const std::vector<std::string>& known) {
    for (const std::string& key : value.keys()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        note(value.place() + ": key " + in_quotes(key) + " is not read");
      }
    }
  }

  void properties(const JsonValue& top) {
    const auto given = top.find("properties");
    if (!given) {
      note(pattern_.source + ": no 'properties'; lengths are taken as centimetres");
      return;
    }
    unread(*given, {"curvature_coords", "normalize_panel_translation", "normalized_edge_loops",
                    "units_in_meter", "original_units_in_meter"});
    if (const auto units = given->find("units_in_meter")) {
      const double value = units->number();
      if (value < 1e-3 || value > 1e6) units->fail("is not between 0.001 and 1,000,000");
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
    if (const auto loops = given->find("normalized_edge_loops")) end_to_start_ = loops->flag();
  }

  void panels(const JsonValue& content) {
    const JsonValue list = content.get("panels");
    const std::vector<std::string> listed = list.keys();
    if (listed.empty()) list.fail("holds no panel");
    refuse_more(list, listed.size(), max_panels, "panels");
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    if (const auto order = content.find("panel_order")) {
      for (std::size_t i = 0; i < order->size(); ++i) {
        const std::string name = order->item(i).text();
        if (std::find(listed.begin(), listed.end(), name) != listed.end()) add(name);
      }
    }
    for (const std::string& name : listed) add(name);
    for (const std::string& name : names) {
      const bool printable = !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' || c == '#' || c == '\\';
      });
      if (!printable || name.front() == ' ' || name.back() == ' ') {
        list.fail("a panel is named " + in_quotes(name), "give it a name of letters and digits");
      }
      panel(name, list.get(name).called(pattern_.source + ": panel " + in_quotes(name)));
    }
  }

  Vec2 metres(const JsonValue& point) const {
    Vec2 value = pair(point) * unit_;
    if (value.cwiseAbs().maxCoeff() > max_metres) {
      point.fail("lies more than a kilometre away", "check 'units_in_meter'");
    }
    return value;
  }

  void panel(const std::string& name, const JsonValue& value) {
    unread(value, {"translation", "rotation", "vertices", "edges", "label", "placement", "grain",
                   "fabric", "attach", "notches", "internal_lines", "cut_outs", "drill_holes",
                   "material", "quantity", "left_out"});
    PatternPanel panel;
    panel.name = name;
    if (const auto translation = value.find("translation")) {
      panel.translation = triple(*translation) * unit_;
      if (panel.translation.cwiseAbs().maxCoeff() > max_metres) {
        translation->fail("is more than a kilometre", "check 'units_in_meter'");
      }
      panel.origin = panel.translation;
    }
    if (const auto rotation = value.find("rotation")) {
      const Vec3 angles = triple(*rotation) * radians_per_degree;
      panel.rotation = (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) *
                        Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                        Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
                           .toRotationMatrix();
    }
    if (const auto grain = value.find("grain")) panel.grain = grain->number() * radians_per_degree;
    if (const auto fabric = value.find("fabric")) panel.fabric = fabric->text();
    if (const auto label = value.find("label")) panel.label = label->text();
    if (const auto placement = value.find("placement")) {
      panel.part = read_part(*placement);
      panel.placement = read_placement(*placement, panel.part, unit_);
    }

    const JsonValue vertices = value.get("vertices");
    const std::size_t count = vertices.size(2);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(metres(vertices.item(i)));
    if (centre_panels_) {
      Vec2 centre = Vec2::Zero();
      for (const Vec2& point : points) centre += point / static_cast<double>(count);
      for (Vec2& point : points) point -= centre;
      panel.translation += Vec3(centre.x(), centre.y(), 0);
      offset_ = centre;
      if (panel.placement.level)
        *panel.placement.level -= upright(panel.placement.axis, centre).y();
    }
    edges(panel, value.get("edges"), points);
    marks(panel, value, points);
    if (const auto attach = value.find("attach")) {
      panel.attachments = read_panel_attachments(attach->called(value.place() + ", attach"),
                                                 value.get("edges"), unit_);
    }
    if (panel.placement.by_part()) {
      for (const char* key : {"translation", "rotation"}) {
        if (!value.find(key)) continue;
        note(value.place() + ": '" + key +
             "' is not used: 'placement' says where the panel stands");
      }
      stand_schematically(panel);
    }
    pattern_.panels.push_back(std::move(panel));
  }

  /// Notches, lines within the outline, and how the panel is cut.
  void marks(PatternPanel& panel, const JsonValue& value, const std::vector<Vec2>& points) {
    if (const auto notches = value.find("notches")) {
      for (std::size_t i = 0; i < notches->size(); ++i) {
        const JsonValue entry =
            notches->item(i).called(value.place() + ", notch " + std::to_string(i));
        unread(entry, {"vertex", "angle"});
        PanelNotch notch;
        notch.vertex = entry.get("vertex").index(static_cast<int>(points.size()));
        notch.at = points[static_cast<std::size_t>(notch.vertex)];
        if (const auto angle = entry.find("angle")) {
          notch.angle = angle->number() * radians_per_degree;
        }
        panel.notches.push_back(notch);
      }
    }
    const Vec2 origin = centre_panels_ ? offset_ : Vec2::Zero();
    const auto drawn = [&](const JsonValue& list, std::size_t least) {
      std::vector<Vec2> line;
      const std::size_t count = list.size(least);
      for (std::size_t i = 0; i < count; ++i) line.push_back(metres(list.item(i)) - origin);
      return line;
    };
    const auto lines = [&](const char* key, std::size_t least, std::vector<std::vector<Vec2>>& to) {
      const auto list = value.find(key);
      if (!list) return;
      for (std::size_t i = 0; i < list->size(); ++i) {
        to.push_back(drawn(
            list->item(i).called(value.place() + ", " + key + " " + std::to_string(i)), least));
      }
    };
    lines("internal_lines", 2, panel.internal_lines);
    lines("cut_outs", 3, panel.cut_outs);
    if (const auto holes = value.find("drill_holes")) panel.drill_holes = drawn(*holes, 0);
    if (const auto material = value.find("material")) panel.material = material->text();
    if (const auto reason = value.find("left_out")) {
      panel.left_out = reason->text();
      if (panel.left_out.empty()) reason->fail("is empty", "say why, or remove the key");
    }
    if (const auto quantity = value.find("quantity")) {
      constexpr int max_quantity = 1000;
      panel.quantity = quantity->index(max_quantity + 1);
      if (panel.quantity < 1) quantity->fail("is no number of pieces");
    }
    const std::size_t unmeshed =
        panel.internal_lines.size() + panel.cut_outs.size() + panel.drill_holes.size();
    if (unmeshed > 0) {
      note(value.place() + ": " + std::to_string(panel.internal_lines.size()) +
           " internal lines, " + std::to_string(panel.cut_outs.size()) + " cut-outs and " +
           std::to_string(panel.drill_holes.size()) + " drill holes are not meshed");
    }
  }

  void edges(PatternPanel& panel, const JsonValue& list, const std::vector<Vec2>& points) {
    const std::string place = pattern_.source + ": panel " + in_quotes(panel.name);
    const std::size_t count = list.size(2);
    refuse_more(list.called(place), count, max_panel_edges, "edges");
    std::vector<std::array<int, 2>> ends;
    for (std::size_t i = 0; i < count; ++i) {
      const JsonValue edge = list.item(i).called(place + ", edge " + std::to_string(i));
      unread(edge, {"endpoints", "curvature", "label", "elastic"});
      const JsonValue endpoints = edge.get("endpoints");
      endpoints.size(2, 2);
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
      if (const auto given = edge.find("elastic")) read.elastic = elastic(*given);
      panel.edges.push_back(std::move(read));
    }
    panel.outline = loop(place, ends);
  }

  Elastic elastic(const JsonValue& value) {
    unread(value, {"ratio", "stiffness_N"});
    Elastic elastic;
    const JsonValue ratio = value.get("ratio");
    elastic.ratio = ratio.number();
    if (!(elastic.ratio >= 0.1 && elastic.ratio <= 1)) {
      ratio.fail("is not between 0.1 and 1", "it is the elastic's length at rest over the edge's");
    }
    const auto stiffness = value.find("stiffness_N");
    elastic.stiffness = stiffness ? stiffness->number() : usual_elastic_stiffness;
    if (!(elastic.stiffness > 0 && elastic.stiffness <= 1e4)) {
      stiffness->fail("is not between 0 and 10,000 N", "a waistband's is some 20");
    }
    return elastic;
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

  EdgeCurve curve(const JsonValue& edge, const Vec2& start, const Vec2& end) {
    const auto curvature = edge.find("curvature");
    if (!curvature) return EdgeCurve::line(start, end);
    // The first generation of the format knew one kind of curve: a lone quadratic control point.
    if (curvature->is_array()) {
      return EdgeCurve::quadratic(start, control(*curvature, start, end), end);
    }
    unread(*curvature, {"type", "params"});
    const JsonValue type = curvature->get("type");
    const std::string kind = type.text();
    const JsonValue params = curvature->get("params");
    if (kind == "quadratic") {
      params.size(1, 1);
      return EdgeCurve::quadratic(start, control(params.item(0), start, end), end);
    }
    if (kind == "cubic") {
      params.size(2, 2);
      return EdgeCurve::cubic(start, control(params.item(0), start, end),
                              control(params.item(1), start, end), end);
    }
    if (kind == "cubics") return chain(params, start, end);
    if (kind != "circle") {
      type.fail(in_quotes(kind) + " is unknown", "use quadratic, cubic, cubics or circle");
    }
    params.size(3, 3);
    const double radius = params.item(0).number() * unit_;
    if (!(radius > 0) || radius > 1e6) params.item(0).fail("is no radius");
    const double half = (end - start).norm() / 2;
    if (radius < half * (1 - radius_note_threshold)) {
      note(edge.place() + ": the circle's radius is too short to reach; half the chord is taken");
    }
    return EdgeCurve::arc(start, end, radius, params.item(1).flag(), params.item(2).flag());
  }

  /// Cubic curves that follow each other: two control points of each, and the joints between.
  EdgeCurve chain(const JsonValue& params, const Vec2& start, const Vec2& end) const {
    const std::size_t count = params.size(2, 3 * static_cast<std::size_t>(max_chain_curves) - 1);
    if (count % 3 != 2) {
      params.fail("has " + std::to_string(count) + " points instead of 2, 5, 8 and so on",
                  "give two control points for each curve, and the joints between");
    }
    std::vector<EdgeCurve> parts;
    for (std::size_t i = 0; i < count; i += 3) {
      const Vec2 from = parts.empty() ? start : parts.back().end();
      const Vec2 to = i + 2 < count ? control(params.item(i + 2), start, end) : end;
      if (from == to) params.fail("has a curve that ends where it starts", "remove it");
      parts.push_back(EdgeCurve::cubic(from, control(params.item(i), start, end),
                                       control(params.item(i + 1), start, end), to));
    }
    return EdgeCurve::chain(std::move(parts));
  }

  /// A control point in metres. The file states it in the panel's drawing or in the frame of the
  /// edge. That frame has the start at 0, the end at (1, 0) and y to its left.
  Vec2 control(const JsonValue& value, const Vec2& start, const Vec2& end) const {
    if (absolute_) return metres(value) - offset_;
    const Vec2 relative = pair(value);
    const Vec2 run = end - start;
    Vec2 point = start + relative.x() * run + relative.y() * Vec2(-run.y(), run.x());
    if (!(point.cwiseAbs().maxCoeff() <= max_metres)) value.fail("lies more than a kilometre away");
    return point;
  }

  static JsonValue side_of(const JsonValue& stitch, std::size_t which) {
    return stitch.item(which).called(stitch.place() + ", side " + std::to_string(which));
  }

  EdgeRef side(const JsonValue& stitch, std::size_t which) const {
    const JsonValue value = side_of(stitch, which);
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

  void stitch(const JsonValue& value) {
    value.size(2, 3);
    Stitch stitch;
    if (end_to_start_) stitch.direction = StitchDirection::end_to_start;
    stitch.a = side(value, 0);
    stitch.b = side(value, 1);
    for (std::size_t which = 0; which < 2; ++which) {
      unread(side_of(value, which), {"panel", "edge"});
    }
    if (value.size() == 3) {
      const JsonValue extra = value.item(2);
      if (extra.is_text()) {
        // GarmentCode's word for an edge that is sewn with its wrong side out.
        if (extra.text() != "right_wrong") extra.fail(in_quotes(extra.text()) + " is unknown");
        stitch.direction = StitchDirection::start_to_start;
      } else {
        if (!extra.is_object()) extra.fail("is neither 'right_wrong' nor an object");
        unread(extra, {"name", "reversed", "gather"});
        if (const auto name = extra.find("name")) stitch.name = name->text();
        if (const auto gather = extra.find("gather")) {
          stitch.gathered = true;
          if (gather->is_flag()) {
            stitch.gathered = gather->flag();
          } else {
            stitch.fullness = gather->number();
            if (!(stitch.fullness >= 1 && stitch.fullness <= 20)) {
              gather->fail("is no fullness between 1 and 20",
                           "use true, or the longer side over the shorter: 1.5");
            }
          }
        }
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
  bool end_to_start_ = false;  ///< GarmentCode's convention of seam directions holds
  Vec2 offset_ = Vec2::Zero();
};

}  // namespace

bool has_places(const Pattern& pattern) {
  const PatternPanel* first = nullptr;
  int count = 0;
  for (const PatternPanel& panel : pattern.panels) {
    if (panel.placement.by_part()) continue;
    if (first == nullptr) first = &panel;
    if ((panel.origin - first->origin).norm() > same_origin) return true;
    ++count;
  }
  return count < 2 && static_cast<std::size_t>(count) < pattern.panels.size();
}

std::string edge_name(const Pattern& pattern, const EdgeRef& ref) {
  return "panel " + in_quotes(pattern.panels.at(static_cast<std::size_t>(ref.panel)).name) +
         ", edge " + std::to_string(ref.edge);
}

Pattern parse_drawn_pattern(const std::string& text, const std::string& name,
                            std::vector<Remark>& remarks) {
  // XML, a zip archive and, with a group code, DXF begin with one of these.
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first != std::string::npos &&
      std::string_view("<P0123456789").find(text[first]) != std::string_view::npos) {
    throw Error(name, "is no pattern that can be read",
                "give GarmentCode JSON; import-pattern makes it from DXF and SVG");
  }
  const JsonDocument document(text, name);
  return Reader(name, remarks).read(document.root());
}

Pattern parse_pattern(const std::string& text, const std::string& name,
                      std::vector<Remark>& remarks) {
  Pattern pattern = parse_drawn_pattern(text, name, remarks);
  sew_crossed_rows_as_one(pattern, remarks);
  merge_short_edges(pattern, remarks);
  open_sharp_corners(pattern, remarks);
  return pattern;
}

Pattern read_pattern(const std::filesystem::path& path, std::vector<Remark>& remarks) {
  return parse_pattern(read_file(path), path.string(), remarks);
}

}  // namespace toile
