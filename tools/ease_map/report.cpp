#include "tools/ease_map/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/decimate.h"
#include "io/csv.h"
#include "io/text.h"
#include "io/view/picture.h"
#include "io/view/viewer_page.h"
#include "tools/report.h"

namespace toile {

namespace {

constexpr const char* definition =
    "distance from a point of the garment to the nearest point of the body's surface, negative "
    "inside the body";

/// Enough to look smooth; a body's 50 thousand would be two thirds of the page.
constexpr int page_body_triangles = 16000;

std::string mm(double metres) { return fixed_number(1000 * metres, 1); }
std::string cm(double metres) { return fixed_number(100 * metres, 1); }
std::string percent_text(double share) { return fixed_number(100 * share, 1); }

ColourRamp ramp_mm(const EaseReport& report) { return magnitude_ramp(0, 1000 * report.top); }

std::vector<double> gaps_mm(const EaseReport& report) {
  std::vector<double> gaps;
  for (const double gap : report.map.node_gaps) gaps.push_back(1000 * gap);
  return gaps;
}

/// To four decimals: a tenth of a micrometre in mm is finer than anything measured here.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

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

PageTable girth_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Girth ease around the torso, cm";
  table.columns = {"level", "height", "body", "garment", "ease", "as cut", "ease as cut"};
  for (const GirthEase& girth : report.girths.levels) {
    table.rows.push_back({girth.level, cm(girth.height), cm(girth.body), cm(girth.garment),
                          cm(girth.ease), cm(girth.as_cut), cm(girth.as_cut - girth.body)});
  }
  table.remark =
      "Horizontal sections. The body is measured as a tape does, across hollows; the garment along "
      "the cloth with its folds. As cut: the sum of the widths of the flat panels where the level "
      "crosses them. Heights are above the floor.";
  for (const LevelLeftOut& level : report.girths.left_out) {
    table.remark += " The " + level.level + " is left out: " + level.why + ".";
  }
  return table;
}

PageTable garment_level_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Levels of the garment itself, cm";
  table.columns = {"level", "height", "body there", "garment", "as cut", "ease as cut"};
  for (const GarmentLevel& level : report.garment_levels) {
    table.rows.push_back({level.name, cm(level.height), level.body ? cm(*level.body) : "",
                          cm(level.garment), cm(level.as_cut),
                          level.body ? cm(level.as_cut - *level.body) : ""});
  }
  table.remark =
      "Along the edge or seam, which need not lie level. Its height is the mean. The body is the "
      "trunk at that height.";
  return table;
}

PageTable limb_table(const EaseReport& report) {
  PageTable table;
  table.caption = "Girth ease around arms and legs, cm";
  table.columns = {"limb", "height", "body", "garment", "ease", "as cut", "ease as cut"};
  for (const LimbEase& limb : report.limbs) {
    table.rows.push_back({limb.limb, cm(limb.at.y()), cm(limb.body), cm(limb.garment),
                          cm(limb.garment - limb.body), cm(limb.as_cut),
                          cm(limb.as_cut - limb.body)});
  }
  table.remark =
      "Sections square to the bone, where the garment is cut the least for the limb. Heights are "
      "those of the bone's point.";
  return table;
}

nlohmann::ordered_json girths_json(const EaseReport& report) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const GirthEase& girth : report.girths.levels) {
    nlohmann::ordered_json row;
    if (!girth.level.empty()) row["level"] = girth.level;
    row["height_cm"] = rounded(100 * girth.height);
    row["body_cm"] = rounded(100 * girth.body);
    row["garment_cm"] = rounded(100 * girth.garment);
    row["ease_cm"] = rounded(100 * girth.ease);
    row["as_cut_cm"] = rounded(100 * girth.as_cut);
    row["as_cut_ease_cm"] = rounded(100 * (girth.as_cut - girth.body));
    row["panels"] = nlohmann::ordered_json::array();
    for (const PanelWidth& panel : girth.panels) {
      row["panels"].push_back({{"name", valid_utf8(report.garment.panels[panel.panel])},
                               {"flat_height_cm", rounded(100 * panel.flat_height)},
                               {"width_cm", rounded(100 * panel.width)},
                               {"along_edge", panel.along_edge}});
    }
    all.push_back(std::move(row));
  }
  return all;
}

nlohmann::ordered_json garment_levels_json(const EaseReport& report) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const GarmentLevel& level : report.garment_levels) {
    nlohmann::ordered_json row = {{"name", level.name},
                                  {"height_cm", rounded(100 * level.height)},
                                  {"garment_cm", rounded(100 * level.garment)},
                                  {"as_cut_cm", rounded(100 * level.as_cut)}};
    if (level.body) {
      row["body_cm"] = rounded(100 * *level.body);
      row["as_cut_ease_cm"] = rounded(100 * (level.as_cut - *level.body));
    }
    all.push_back(std::move(row));
  }
  return all;
}

nlohmann::ordered_json limbs_json(const EaseReport& report) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const LimbEase& limb : report.limbs) {
    all.push_back({{"limb", limb.limb},
                   {"share", rounded(limb.share)},
                   {"height_cm", rounded(100 * limb.at.y())},
                   {"body_cm", rounded(100 * limb.body)},
                   {"garment_cm", rounded(100 * limb.garment)},
                   {"ease_cm", rounded(100 * (limb.garment - limb.body))},
                   {"as_cut_cm", rounded(100 * limb.as_cut)},
                   {"as_cut_ease_cm", rounded(100 * (limb.as_cut - limb.body))}});
  }
  return all;
}

std::string dressing_line(const DressReport& dressing) {
  return verdict_line(dressing.verdict, text_of(dressing.fit));
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
  std::string text = "panel,u_m,v_m,x_m,y_m,z_m,gap_mm\n";
  for (const PointGap& point : report.map.points) {
    const Vec2& flat = report.garment.flat[static_cast<std::size_t>(point.flat)];
    const Vec3& place = report.garment.points[static_cast<std::size_t>(point.node)];
    text += names[static_cast<std::size_t>(point.panel)];
    for (const double value : {flat.x(), flat.y(), place.x(), place.y(), place.z()}) {
      text += ',';
      append_number(text, value);
    }
    text += ',' + fixed_number(1000 * point.gap, 4) + '\n';
  }
  return text;
}

nlohmann::ordered_json ease_json(const EaseReport& report) {
  nlohmann::ordered_json json;
  json["garment"] = valid_utf8(report.garment_name);
  json["body"] = valid_utf8(report.body_name);
  if (report.dressing) {
    json["verdict"] = report.dressing->verdict;
    json["fit"] = to_string(report.dressing->fit);
  }
  json["warnings"] = warnings_json(report.warnings);
  json["notes"] = report.notes;
  json["gap"] = definition;
  json["contact_below_mm"] = 1000 * report.options.contact;
  json["total"] = statistics_json(report.map.garment);
  json["panels"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < report.map.panels.size(); ++i) {
    if (report.map.panels[i].points == 0) continue;
    nlohmann::ordered_json panel = {{"name", valid_utf8(report.garment.panels[i])}};
    panel.update(statistics_json(report.map.panels[i]));
    json["panels"].push_back(std::move(panel));
  }
  if (!report.girths.levels.empty()) json["girths"] = girths_json(report);
  for (const LevelLeftOut& level : report.girths.left_out) {
    json["levels_left_out"].push_back({{"level", level.level}, {"why", level.why}});
  }
  if (!report.garment_levels.empty()) json["garment_levels"] = garment_levels_json(report);
  if (!report.limbs.empty()) json["limbs"] = limbs_json(report);
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
  if (report.dressing) {
    page.paragraphs.insert(page.paragraphs.begin(),
                           "Dressing: " + dressing_line(*report.dressing) + ".");
  }
  for (const Warning& warning : report.warnings) {
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
  if (!report.girths.levels.empty()) page.tables.push_back(girth_table(report));
  if (!report.garment_levels.empty()) page.tables.push_back(garment_level_table(report));
  if (!report.limbs.empty()) page.tables.push_back(limb_table(report));
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

std::vector<Colour> ease_colours(const EaseReport& report) {
  const ColourRamp ramp = ramp_mm(report);
  std::vector<Colour> colours;
  for (const double gap : gaps_mm(report)) colours.push_back(ramp.at(gap));
  return colours;
}

std::vector<std::string> ease_summary(const EaseReport& report) {
  std::vector<std::string> lines;
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
  for (const GirthEase& girth : report.girths.levels) {
    if (girth.level.empty()) continue;
    lines.push_back(girth.level + " girth ease " + cm(girth.ease) + " cm (garment " +
                    cm(girth.garment) + ", body " + cm(girth.body) + "), " +
                    cm(girth.as_cut - girth.body) + " cm as cut (" + cm(girth.as_cut) + ")");
  }
  for (const LevelLeftOut& level : report.girths.left_out) {
    lines.push_back("no girth ease at the " + level.level + ": " + level.why);
  }
  if (report.dressing) lines.push_back(dressing_line(*report.dressing));
  return lines;
}

}  // namespace toile
