#include "tools/ease_map/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cloth/ease/figure_errors.h"
#include "io/csv.h"
#include "io/text.h"
#include "tools/ease_map/against.h"
#include "tools/ease_map/findings.h"
#include "tools/ease_map/load_report.h"
#include "tools/ease_map/maps.h"
#include "tools/ease_map/numbers.h"
#include "tools/ease_map/tables.h"
#include "tools/report.h"

namespace toile {

namespace {

constexpr const char* definition =
    "distance from a point of the garment to the nearest point of the body's surface, negative "
    "inside the body";

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

nlohmann::ordered_json against_json(const EaseReport& report) {
  nlohmann::ordered_json json = {{"garment", valid_utf8(report.against)},
                                 {"differences", nlohmann::ordered_json::array()}};
  for (const FigureDifference& row : differences(report, *report.other)) {
    json["differences"].push_back({{"of", row.what},
                                   {"name", row.name},
                                   {"here_cm", rounded(100 * row.here)},
                                   {"there_cm", rounded(100 * row.there)},
                                   {"difference_cm", rounded(100 * row.difference())},
                                   {"plus_minus_difference_cm", rounded(100 * row.error)},
                                   {"is_sure", row.is_sure()}});
  }
  return json;
}

/// The fit of the dressing. What is large enough may be too wide against a target.
bool fits_too_wide(const EaseReport& report) {
  return report.dressing->fit.levels.empty() && is_too_wide(report.targets);
}

}  // namespace

std::string dressing_line(const EaseReport& report) {
  return verdict_line(report.dressing->verdict,
                      fits_too_wide(report) ? "too_wide" : text_of(report.dressing->fit));
}

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
  json["garment"] = valid_utf8(report.garment_file);
  json["body"] = valid_utf8(report.body_file);
  if (report.dressing) {
    json["verdict"] = report.dressing->verdict;
    const Fit& fit = report.dressing->fit;
    json["fit"] =
        fit_json(fit, fits_too_wide(report) ? "too_wide" : to_string(fit), report.garment.panels);
  }
  json["findings"] = finding_texts(report);
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
  if (report.other) json["against"] = against_json(report);
  return json;
}

MeshProperties ease_properties(const EaseReport& report) {
  const EaseScale scale = ease_scale(report);
  MeshProperties properties;
  for (const double value : scale.nodes) properties.colours.push_back(scale.bar.ramp.at(value));
  MeshProperty& gaps = properties.points.emplace_back();
  gaps.name = "gap_mm";
  for (const double gap : report.map.node_gaps) gaps.values.push_back(1000 * gap);
  if (report.loads) add_loads(*report.loads, properties);
  return properties;
}

std::vector<std::string> ease_summary(const EaseReport& report) {
  std::vector<std::string> lines = finding_texts(report);
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
