#include "tools/ease_map/report.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "cloth/ease/figure_errors.h"
#include "geometry/decimate.h"
#include "io/csv.h"
#include "io/text.h"
#include "io/view/picture.h"
#include "io/view/viewer_page.h"
#include "tools/ease_map/findings.h"
#include "tools/ease_map/load_report.h"
#include "tools/ease_map/numbers.h"
#include "tools/report.h"

namespace toile {

namespace {

constexpr const char* definition =
    "distance from a point of the garment to the nearest point of the body's surface, negative "
    "inside the body";

/// Enough to look smooth; a body's 50 thousand would be two thirds of the page.
constexpr int page_body_triangles = 16000;

ColourRamp ramp_mm(const EaseReport& report) { return magnitude_ramp(0, 1000 * report.top); }

std::vector<double> gaps_mm(const EaseReport& report) {
  std::vector<double> gaps;
  for (const double gap : report.map.node_gaps) gaps.push_back(1000 * gap);
  return gaps;
}

nlohmann::ordered_json statistics_json(const EaseStatistics& statistics) {
  const auto in_mm = [](double metres) { return rounded(1000 * metres); };
  return {{"points", statistics.points},
          {"area_cm2", rounded(1e4 * statistics.area)},
          {"mean_mm", in_mm(statistics.mean)},
          {"std_mm", in_mm(statistics.deviation)},
          {"min_mm", in_mm(statistics.min)},
          {"p5_mm", in_mm(statistics.p5)},
          {"p50_mm", in_mm(statistics.p50)},
          {"p95_mm", in_mm(statistics.p95)},
          {"max_mm", in_mm(statistics.max)},
          {"contact_percent", rounded(100 * statistics.contact)},
          {"inside_percent", rounded(100 * statistics.inside)}};
}

std::vector<std::string> statistics_row(const std::string& name, const EaseStatistics& s) {
  return {name,
          mm(s.mean),
          mm(s.p50),
          mm(s.p5) + " \xE2\x80\x93 " + mm(s.p95),
          mm(s.min),
          mm(s.max),
          percent_text(s.contact)};
}

PageTable panel_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Gap by panel, mm";
  table.columns = {"panel", "mean", "median", "5 \xE2\x80\x93 95 %", "min", "max", "contact, %"};
  for (std::size_t i = 0; i < report.map.panels.size(); ++i) {
    if (report.map.panels[i].points == 0) continue;
    table.rows.push_back(statistics_row(report.garment.panels[i], report.map.panels[i]));
    table.regions.push_back(static_cast<int>(i));
  }
  table.rows.push_back(statistics_row("whole garment", report.map.garment));
  table.regions.push_back(-1);
  table.remark = "Weighted by area. Contact is the share of the area with a gap below " +
                 mm(report.options.contact) +
                 " mm. Point at a row to see its panel alone; click to keep it.";
  return table;
}

/// "left wrist" and "right wrist" are one row.
struct GirthRow {
  std::string name;
  const Girth* left = nullptr;   ///< or that of the trunk
  const Girth* right = nullptr;  ///< null: it has no sides, or the garment is not closed there
};

std::vector<GirthRow> girth_rows(const EaseReport& report) {
  std::vector<GirthRow> rows;
  for (const Girth& girth : report.figures.girths.rows) {
    const bool is_right = girth.name.starts_with("right ");
    const bool has_side = is_right || girth.name.starts_with("left ");
    const std::string name = has_side ? girth.name.substr(girth.name.find(' ') + 1) : girth.name;
    const auto pair = std::ranges::find_if(rows, [&](const GirthRow& row) {
      return is_right && row.name == name && row.left != nullptr &&
             row.left->name == "left " + name;
    });
    if (pair != rows.end()) {
      pair->right = &girth;
    } else {
      rows.push_back({name, is_right ? nullptr : &girth, is_right ? &girth : nullptr});
    }
  }
  return rows;
}

PageTable girth_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Girths of body and garment, cm";
  table.columns = {"girth", "height",   "body",   "garment",
                   "ease",  "\xC2\xB1", "as cut", "ease as cut"};
  for (const GirthRow& row : girth_rows(report)) {
    const auto cell = [&](const std::function<std::string(const Girth&)>& text) {
      if (row.left == nullptr) return "\xE2\x80\x93 | " + text(*row.right);
      return text(*row.left) + (row.right == nullptr ? "" : " | " + text(*row.right));
    };
    const auto where_girth = [&](const std::function<std::string(const Girth&)>& text) {
      return cell([&](const Girth& girth) {
        return girth.is_girth() ? text(girth) : std::string("no girth here: a fold");
      });
    };
    const auto blank_at_fold = [&](const std::function<std::string(const Girth&)>& text) {
      return cell(
          [&](const Girth& girth) { return girth.is_girth() ? text(girth) : std::string(); });
    };
    table.rows.push_back(
        {row.name, cell([](const Girth& girth) { return cm(girth.height); }),
         cell([](const Girth& girth) { return cm(girth.body); }),
         where_girth([](const Girth& girth) { return cm(girth.garment); }),
         blank_at_fold([](const Girth& girth) { return cm(girth.ease()); }),
         blank_at_fold([](const Girth& girth) { return cm(girth.error); }),
         blank_at_fold([](const Girth& girth) { return cm(girth.as_cut); }),
         blank_at_fold([](const Girth& girth) { return cm(girth.ease_as_cut()); })});
  }
  table.remark =
      "Where there are two numbers they are of left and right. The body is measured as a tape "
      "does, "
      "across hollows; the garment along the cloth with its folds. Ease is that of the cloth's "
      "inner face. As cut: the widths of the flat panels where the level crosses them. Heights are "
      "above the floor. A skirt's thigh and knee go around both legs as they stand.";
  for (const GirthLeftOut& level : report.figures.girths.left_out) {
    table.remark += " The " + level.name + " is left out: " + level.why + ".";
  }
  return table;
}

PageTable garment_level_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Edges and waist seam of the garment, cm";
  table.columns = {"edge",       "drafted at", "rests at", "\xC2\xB1",   "moved by",
                   "body there", "garment",    "as cut",   "ease as cut"};
  for (const GarmentLevel& level : report.figures.levels) {
    const std::optional<double> body = level.drafted_body ? level.drafted_body : level.body;
    table.rows.push_back({level.name, level.drafted ? cm(*level.drafted) : "", cm(level.height),
                          cm(level.height_error), level.drafted ? cm(*level.risen()) : "",
                          body ? cm(*body) : "", cm(level.garment), cm(level.as_cut),
                          body ? cm(level.as_cut - *body) : ""});
  }
  table.remark =
      "Along the edge or seam, which need not lie level. Its height is the mean. Moved by is how "
      "much higher it hangs than drafted. The body is measured where the edge was drafted to lie, "
      "or where it rests if that is not known.";
  return table;
}

std::string beyond_text(const EndsBeyond& end) {
  if (end.place == "floor") return cm(end.by) + " above the floor";
  return cm(std::abs(end.by)) + (end.by < 0 ? " short of the " : " beyond the ") + end.place;
}

std::string ends_text(const GarmentLength& length) {
  std::string text;
  for (const EndsBeyond& end : length.ends) text += (text.empty() ? "" : ", ") + beyond_text(end);
  return text;
}

PageTable length_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Lengths of the garment, cm";
  table.columns = {"length", "as cut", "as worn", "\xC2\xB1", "body", "ends"};
  for (const GarmentLength& length : report.figures.lengths) {
    table.rows.push_back({length.name, length.as_cut ? cm(*length.as_cut) : "", cm(length.worn),
                          cm(length.error), length.body ? cm(*length.body) : "",
                          ends_text(length)});
  }
  table.remark =
      "As cut: straight across each flat panel along the line; of crotch length and rises along "
      "their seam. As worn: along the cloth; across shoulder straight to the centre back and on; "
      "of a neck drop the height. Where a sleeve or a shoulder ends is told along the arm, beyond "
      "a knee is below it.";
  return table;
}

nlohmann::ordered_json lengths_json(const EaseReport& report) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const GarmentLength& length : report.figures.lengths) {
    nlohmann::ordered_json row = {{"name", length.name}};
    if (length.as_cut) row["as_cut_cm"] = rounded(100 * *length.as_cut);
    row["worn_cm"] = rounded(100 * length.worn);
    row["plus_minus_worn_cm"] = rounded(100 * length.error);
    if (length.body) row["body_cm"] = rounded(100 * *length.body);
    for (const EndsBeyond& end : length.ends) {
      row["ends"].push_back({{"place", end.place},
                             {"beyond_cm", rounded(100 * end.by)},
                             {"plus_minus_beyond_cm", rounded(100 * end.error)}});
    }
    all.push_back(std::move(row));
  }
  return all;
}

nlohmann::ordered_json girths_json(const EaseReport& report) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  const auto in_cm = [](double metres) { return rounded(100 * metres); };
  for (const Girth& girth : report.figures.girths.rows) {
    nlohmann::ordered_json row;
    if (!girth.name.empty()) row["level"] = girth.name;
    row["height_cm"] = in_cm(girth.height);
    row["body_cm"] = in_cm(girth.body);
    row["section_over_hull"] = rounded(girth.garment / girth.hull);
    if (!girth.is_girth()) {
      row["no_girth"] = "a fold";
      all.push_back(std::move(row));
      continue;
    }
    row["garment_cm"] = in_cm(girth.garment);
    row["offset_cm"] = in_cm(girth.offset);
    row["ease_cm"] = in_cm(girth.ease());
    row["plus_minus_ease_cm"] = in_cm(girth.error);
    row["as_cut_cm"] = in_cm(girth.as_cut);
    row["as_cut_ease_cm"] = in_cm(girth.ease_as_cut());
    row["plus_minus_as_cut_cm"] = in_cm(as_cut_error(girth.as_cut, girth.on_the_line));
    row["on_the_line_cm"] = in_cm(girth.on_the_line);
    row["panels"] = nlohmann::ordered_json::array();
    for (const PanelWidth& panel : girth.panels) {
      row["panels"].push_back({{"name", valid_utf8(report.garment.panels[panel.panel])},
                               {"flat_height_cm", in_cm(panel.flat_height)},
                               {"width_cm", in_cm(panel.width)},
                               {"on_the_line_cm", in_cm(panel.on_the_line)},
                               {"along_line", panel.along_line}});
    }
    all.push_back(std::move(row));
  }
  return all;
}

nlohmann::ordered_json garment_levels_json(const EaseReport& report) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const GarmentLevel& level : report.figures.levels) {
    nlohmann::ordered_json row = {{"name", level.name},
                                  {"height_cm", rounded(100 * level.height)},
                                  {"garment_cm", rounded(100 * level.garment)},
                                  {"as_cut_cm", rounded(100 * level.as_cut)}};
    row["largest_gap_cm"] =
        rounded(100 * report.map.node_gaps[farthest_node(report.map, level.nodes)]);
    if (level.body) {
      row["body_cm"] = rounded(100 * *level.body);
      row["as_cut_ease_cm"] = rounded(100 * (level.as_cut - *level.body));
    }
    if (level.drafted) {
      row["drafted_height_cm"] = rounded(100 * *level.drafted);
      row["risen_cm"] = rounded(100 * *level.risen());
      row["plus_minus_height_cm"] = rounded(100 * level.height_error);
    }
    if (level.drafted_body) {
      row["drafted_body_cm"] = rounded(100 * *level.drafted_body);
      row["drafted_ease_cm"] = rounded(100 * (level.as_cut - *level.drafted_body));
      row["plus_minus_drafted_ease_cm"] = rounded(100 * level.drafted_body_error);
    }
    all.push_back(std::move(row));
  }
  return all;
}

nlohmann::ordered_json target_json(const EaseReport& report) {
  nlohmann::ordered_json json = {{"name", valid_utf8(report.target)}};
  for (const TargetFinding& finding : report.targets) {
    json["levels"].push_back({{"level", finding.level},
                              {"ease_cm", rounded(100 * finding.ease)},
                              {"plus_minus_ease_cm", rounded(100 * finding.error)},
                              {"least_cm", rounded(100 * finding.target.least)},
                              {"most_cm", rounded(100 * finding.target.most)},
                              {"is", finding.word()},
                              {"off_cm", rounded(100 * finding.off())}});
    if (std::abs(finding.off()) <= finding.error) continue;
    json["levels"].back()["panels"] = names_json(finding.panels, report.garment.panels);
  }
  return json;
}

PageTable target_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Ease against the target, cm";
  table.columns = {"level", "ease as cut", "\xC2\xB1", "meant", "is", "off by"};
  for (const TargetFinding& finding : report.targets) {
    table.rows.push_back({finding.level, cm(finding.ease), cm(finding.error),
                          cm(finding.target.least) + " \xE2\x80\x93 " + cm(finding.target.most),
                          finding.word(), cm(finding.off())});
  }
  table.remark = "The target is '" + report.target +
                 "'. Of an edge the ease is told where it was drafted to lie.";
  return table;
}

/// The fit of the dressing. What is large enough may be too wide against a target.
bool fits_too_wide(const EaseReport& report) {
  return report.dressing->fit.levels.empty() && is_too_wide(report.targets);
}

std::string dressing_line(const EaseReport& report) {
  return verdict_line(report.dressing->verdict,
                      fits_too_wide(report) ? "too_wide" : text_of(report.dressing->fit));
}

std::string title_of(const EaseReport& report) {
  std::string title = "Ease map: " + report.garment_name + " on " + report.body_name;
  if (report.dressing) title += " (" + report.dressing->verdict + ")";
  return title;
}

}  // namespace

double suggested_top(const EaseMap& map) { return round_up(std::max(0.010, map.garment.p95)); }

std::string ease_csv(const EaseReport& report) {
  std::vector<std::string> names;
  for (const std::string& panel : report.garment.panels)
    names.push_back(csv_field(valid_utf8(panel)));
  std::string text = "panel,u_m,v_m,x_m,y_m,z_m,gap_mm";
  NodeLoads loads;
  if (report.loads) {
    loads = loads_at_nodes(report.garment, *report.loads);
    text +=
        ",strain_warp_percent,strain_weft_percent,strain_bias_percent,tension_warp_N_per_m,"
        "tension_weft_N_per_m,pressure_kPa,friction_kPa";
  }
  text += '\n';
  for (const PointGap& point : report.map.points) {
    const Vec2& flat = report.garment.flat[static_cast<std::size_t>(point.flat)];
    const Vec3& place = report.garment.points[static_cast<std::size_t>(point.node)];
    text += names[static_cast<std::size_t>(point.panel)];
    for (const double value : {flat.x(), flat.y(), place.x(), place.y(), place.z()}) {
      text += ',';
      append_number(text, value);
    }
    text += ',' + fixed_number(1000 * point.gap, 4);
    if (report.loads) {
      const auto n = static_cast<std::size_t>(point.node);
      const NodeLoad& load = report.loads->nodes[n];
      for (const double value :
           {100 * loads.strain_warp[n], 100 * loads.strain_weft[n], 100 * loads.strain_bias[n],
            loads.tension_warp[n], loads.tension_weft[n], load.pressure / 1000,
            load.friction / 1000}) {
        text += ',' + fixed_number(value, 4);
      }
    }
    text += '\n';
  }
  return text;
}

nlohmann::ordered_json ease_json(const EaseReport& report) {
  nlohmann::ordered_json json;
  json["garment"] = valid_utf8(report.garment_name);
  json["body"] = valid_utf8(report.body_name);
  if (report.dressing) {
    json["verdict"] = report.dressing->verdict;
    const Fit& fit = report.dressing->fit;
    json["fit"] =
        fit_json(fit, fits_too_wide(report) ? "too_wide" : to_string(fit), report.garment.panels);
  }
  json["findings"] = findings_of(report);
  json["warnings"] = warnings_json(report.warnings);
  json["notes"] = report.notes;
  json["gap"] = definition;
  for (const RepeatedDrape& drape : report.repeats) {
    nlohmann::ordered_json repeat = {{"garment", valid_utf8(drape.file)}};
    if (!drape.verdict.empty()) repeat["verdict"] = drape.verdict;
    json["repeats"].push_back(std::move(repeat));
  }
  json["contact_below_mm"] = 1000 * report.options.contact;
  json["total"] = statistics_json(report.map.garment);
  json["panels"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < report.map.panels.size(); ++i) {
    if (report.map.panels[i].points == 0) continue;
    nlohmann::ordered_json panel = {{"name", valid_utf8(report.garment.panels[i])}};
    panel.update(statistics_json(report.map.panels[i]));
    json["panels"].push_back(std::move(panel));
  }
  if (!report.figures.girths.rows.empty()) json["girths"] = girths_json(report);
  if (!report.targets.empty()) json["target"] = target_json(report);
  for (const GirthLeftOut& level : report.figures.girths.left_out) {
    json["levels_left_out"].push_back({{"level", level.name}, {"why", level.why}});
  }
  if (!report.figures.levels.empty()) json["garment_levels"] = garment_levels_json(report);
  if (!report.figures.lengths.empty()) json["lengths"] = lengths_json(report);
  if (report.loads) json["loads"] = loads_json(report);
  return json;
}

std::string ease_page(const EaseReport& report, const std::string& picture) {
  ViewerPage page;
  page.title = title_of(report);
  page.paragraphs = {
      "The gap is the distance from a point of the garment to the nearest point of the body's "
      "surface. It is negative inside the body.",
      "Drag to turn, scroll to zoom, drag with the right button to move. Point at the garment to "
      "read its gap. Left and right are the wearer's."};
  std::vector<std::string> first;
  if (report.dressing) first.push_back("Dressing: " + dressing_line(report) + ".");
  const std::vector<std::string> findings = findings_of(report);
  for (std::string finding : findings) {
    finding[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(finding[0])));
    first.push_back(finding + ".");
  }
  page.paragraphs.insert(page.paragraphs.begin(), first.begin(), first.end());
  for (const Warning& warning : report.warnings) {
    if (std::ranges::find(findings, warning.text) != findings.end()) continue;
    page.paragraphs.push_back("Warning: " + warning.text + ".");
  }
  for (const std::string& note : report.notes) page.paragraphs.push_back("Note: " + note + ".");
  page.surface = {report.garment.points, report.garment.triangles};
  page.values = gaps_mm(report);
  page.regions = report.garment.panels;
  page.region_of_triangle = report.garment.panel_of_triangle;
  page.quantity = "Gap";
  page.unit = "mm";
  page.ramp = ramp_mm(report);
  page.below = "inside";
  // Only looked at there: a light body keeps the page small and quick to turn.
  page.setting = decimate(report.body, page_body_triangles);
  page.setting_name = "body";
  page.tables.push_back(panel_table(report));
  if (!report.figures.girths.rows.empty()) page.tables.push_back(girth_table(report));
  if (!report.targets.empty()) page.tables.push_back(target_table(report));
  if (!report.figures.levels.empty()) page.tables.push_back(garment_level_table(report));
  if (!report.figures.lengths.empty()) page.tables.push_back(length_table(report));
  if (report.loads) page.tables.push_back(load_table(report));
  page.still_png = picture;
  return viewer_page(page);
}

std::vector<std::string> ease_pictures(const EaseReport& report, const std::vector<int>& widths) {
  PictureMesh cloth;
  cloth.mesh = {report.garment.points, report.garment.triangles};
  cloth.values = gaps_mm(report);
  cloth.ramp = ramp_mm(report);
  cloth.regions = report.garment.panel_of_triangle;
  cloth.shows_through = 0.03;
  PictureMesh body;
  body.mesh = report.body;
  body.colour = {0.74, 0.72, 0.71};
  body.framed = false;
  body.inside_shown = false;
  Picture picture;
  picture.title = title_of(report);
  picture.bar = ColourBar{"gap, mm", cloth.ramp, "inside"};
  std::vector<PictureMesh> meshes;
  meshes.push_back(std::move(cloth));
  meshes.push_back(std::move(body));
  const RayScene scene(std::move(meshes));
  std::vector<std::string> pictures;
  for (const int width : widths) {
    picture.view_width = width;
    pictures.push_back(picture_png(scene, picture));
  }
  return pictures;
}

MeshProperties ease_properties(const EaseReport& report) {
  const ColourRamp ramp = ramp_mm(report);
  MeshProperties properties;
  const std::vector<double> gaps = gaps_mm(report);
  for (const double gap : gaps) properties.colours.push_back(ramp.at(gap));
  properties.points.push_back({"gap_mm", gaps});
  if (report.loads) add_loads(*report.loads, properties);
  return properties;
}

std::vector<std::string> ease_summary(const EaseReport& report) {
  std::vector<std::string> lines = findings_of(report);
  const auto line = [&](const std::string& name, const EaseStatistics& s) {
    lines.push_back(name + ": gap mean " + mm(s.mean) + " mm, median " + mm(s.p50) + " mm, from " +
                    mm(s.min) + " to " + mm(s.max) + " mm; contact " + percent_text(s.contact) +
                    " %");
  };
  for (std::size_t i = 0; i < report.map.panels.size(); ++i) {
    if (report.map.panels[i].points > 0) {
      line(valid_utf8(report.garment.panels[i]), report.map.panels[i]);
    }
  }
  line("whole garment", report.map.garment);
  for (const Girth& girth : report.figures.girths.rows) {
    if (girth.name.empty()) continue;
    if (!girth.is_girth()) {
      lines.push_back(girth.name + ": no girth here, a fold");
      continue;
    }
    lines.push_back(girth.name + " girth ease " + cm(girth.ease()) + " \xC2\xB1 " +
                    cm(girth.error) + " cm (garment " + cm(girth.garment) + ", body " +
                    cm(girth.body) + "), " + cm(girth.ease_as_cut()) + " cm as cut (" +
                    cm(girth.as_cut) + ")");
  }
  for (const GarmentLevel& level : report.figures.levels) {
    if (!level.drafted) continue;
    lines.push_back(level.name + " drafted at " + cm(*level.drafted) + " cm, rests at " +
                    cm(level.height) + " \xC2\xB1 " + cm(level.height_error) + " cm");
  }
  for (const GarmentLength& length : report.figures.lengths) {
    lines.push_back(
        length.name + " " +
        (length.as_cut ? cm(*length.as_cut) + " cm as cut" : cm(length.worn) + " cm as worn") +
        (length.body ? ", body " + cm(*length.body) + " cm" : "") +
        (length.ends.empty() ? "" : ", ends " + ends_text(length)));
  }
  for (const GirthLeftOut& level : report.figures.girths.left_out) {
    lines.push_back("no girth ease at the " + level.name + ": " + level.why);
  }
  if (report.dressing) lines.push_back(dressing_line(report));
  return lines;
}

}  // namespace toile
