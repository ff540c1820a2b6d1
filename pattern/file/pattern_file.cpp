#include "pattern/file/pattern_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "io/json_value.h"
#include "io/json_words.h"
#include "io/limits.h"
#include "io/output_file.h"
#include "pattern/check/seam_order.h"
#include "pattern/constants.h"
#include "pattern/file/attachment_json.h"
#include "pattern/file/edge_json.h"
#include "pattern/file/placement_json.h"
#include "pattern/layout/schematic_figure.h"
#include "pattern/mesh/sharp_corners.h"
#include "pattern/mesh/short_edges.h"

namespace toile {

namespace {

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

  void unread(const JsonValue& value, const std::vector<std::string>& known) {
    note_unread(value, known, remarks_);
  }

  void properties(const JsonValue& top) {
    const auto given = top.find("properties");
    if (!given) {
      note(pattern_.source + ": no 'properties'; lengths are taken as centimetres");
      return;
    }
    unread(*given, {"curvature_coords", "normalize_panel_translation", "normalized_edge_loops",
                    "units_in_meter", "original_units_in_meter", "up"});
    if (const auto units = given->find("units_in_meter")) {
      const double value = units->number();
      if (value < 1e-3 || value > 1e6) units->fail("is not between 0.001 and 1,000,000");
      frame_.unit = 1 / value;
    } else {
      note(pattern_.source + ": no 'units_in_meter'; lengths are taken as centimetres");
    }
    if (const auto coordinates = given->find("curvature_coords")) {
      const std::string kind = coordinates->text();
      if (kind != "relative" && kind != "absolute") {
        coordinates->fail(in_quotes(kind) + " is unknown", "use 'relative' or 'absolute'");
      }
      frame_.absolute_controls = kind == "absolute";
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

  void panel(const std::string& name, const JsonValue& value) {
    unread(value, {"translation", "rotation", "vertices", "edges", "label", "placement", "grain",
                   "fabric", "attach", "notches", "internal_lines", "cut_outs", "drill_holes",
                   "material", "quantity", "left_out", "side"});
    PatternPanel panel;
    panel.name = name;
    if (const auto translation = value.find("translation")) {
      panel.translation = triple(*translation) * frame_.unit;
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
      panel.placement = read_placement(*placement, panel.part, frame_.unit);
    }

    const JsonValue vertices = value.get("vertices");
    const std::size_t count = vertices.size(2);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i)
      points.push_back(read_point(vertices.item(i), frame_.unit));
    if (centre_panels_) {
      Vec2 centre = Vec2::Zero();
      for (const Vec2& point : points) centre += point / static_cast<double>(count);
      for (Vec2& point : points) point -= centre;
      panel.translation += Vec3(centre.x(), centre.y(), 0);
      frame_.origin = centre;
      if (panel.placement.level)
        *panel.placement.level -= upright(panel.placement.axis, centre).y();
    }
    PanelEdges read = read_edges(value.get("edges"), points, frame_,
                                 pattern_.source + ": panel " + in_quotes(name), remarks_);
    panel.edges = std::move(read.edges);
    panel.outline = std::move(read.outline);
    marks(panel, value, points);
    if (const auto attach = value.find("attach")) {
      panel.attachments = read_panel_attachments(attach->called(value.place() + ", attach"),
                                                 value.get("edges"), frame_.unit);
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
    const auto drawn = [&](const JsonValue& list, std::size_t least) {
      std::vector<Vec2> line;
      const std::size_t count = list.size(least);
      for (std::size_t i = 0; i < count; ++i)
        line.push_back(read_point(list.item(i), frame_.unit) - frame_.origin);
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
    if (const auto side = value.find("side")) {
      if (side->text() != "unknown")
        side->fail("is no side", "write \"unknown\", or remove the key");
      panel.side_unknown = true;
    }
    if (const auto quantity = value.find("quantity")) {
      constexpr int max_quantity = 1000;
      panel.quantity = quantity->index(max_quantity + 1);
      if (panel.quantity < 1) quantity->fail("is no number of pieces");
    }
  }

  static JsonValue side_of(const JsonValue& stitch, std::size_t which) {
    return stitch.item(which).called(stitch.place() + ", side " + std::to_string(which));
  }

  EdgeRef side(const JsonValue& stitch, std::size_t which) const {
    const JsonValue value = side_of(stitch, which);
    const std::string name = value.get("panel").text();
    const auto found = std::find_if(pattern_.panels.begin(), pattern_.panels.end(),
                                    [&](const PatternPanel& panel) { return panel.name == name; });
    if (found == pattern_.panels.end()) {
      stitch.fail("names panel " + in_quotes(name) + " (edge " +
                      std::to_string(value.get("edge").index()) +
                      "), which the pattern does not have",
                  "correct the name or remove the stitch");
    }
    return {static_cast<int>(found - pattern_.panels.begin()),
            read_sewn_edge(stitch, which, name, found->edges.size())};
  }

  static StitchDirection stated_direction(const JsonValue& reversed) {
    // So GarmentCode's convention does not reach a seam that was drawn by hand.
    if (reversed.is_text()) {
      if (reversed.text() != "found") reversed.fail(in_quotes(reversed.text()) + " is unknown");
      return StitchDirection::by_position;
    }
    return reversed.flag() ? StitchDirection::end_to_start : StitchDirection::start_to_start;
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
        unread(extra, {"name", "reversed", "gather", "layer"});
        if (const auto name = extra.find("name")) stitch.name = name->text();
        if (const auto layer = extra.find("layer")) stitch.layered = layer->flag();
        if (stitch.layered) stitch.direction = StitchDirection::start_to_start;
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
          stitch.direction = stated_direction(*reversed);
        }
      }
    }
    pattern_.stitches.push_back(std::move(stitch));
  }

  std::vector<Remark>& remarks_;
  Pattern pattern_;
  DrawingFrame frame_;
  bool centre_panels_ = false;
  bool end_to_start_ = false;  ///< GarmentCode's convention of seam directions holds
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
