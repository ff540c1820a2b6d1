#include "tests/benchmarks/work_precision/page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "cloth/dressing/quality.h"
#include "tests/benchmarks/work_precision/findings.h"
#include "tests/support/html.h"

namespace toile::precision {

namespace {

using html::Cell;
using Json = nlohmann::ordered_json;
using Lines = std::vector<std::vector<Cell>>;

constexpr const char* none = "–";

std::string percent(double fraction) { return fixed_number(100 * fraction, 3); }
std::string seconds(double value) { return number(value, 3); }
Cell end_cell(const Outcome& run) { return {end_of(run), run.sewn ? "" : "bad"}; }

std::string presets_html(const Results& results) {
  Lines lines;
  for (const Preset& preset : presets(results)) {
    const Row& row = *preset.row;
    lines.push_back({{row.scene, ""},
                     {row.value, ""},
                     {std::to_string(row.nodes), ""},
                     {std::to_string(row.outcome.iterations), ""},
                     {seconds(row.outcome.wall), ""},
                     {seconds(row.outcome.processor), ""},
                     {fixed_number(preset.time_ratio, 2), ""},
                     {mm(row.error.rms), ""},
                     {mm(row.error.max), ""},
                     {percent(row.error.strain_p99), ""},
                     {mm(*row.error.ease, 3), ""},
                     {number(row.outcome.residual.median, 2), ""}});
  }
  return "<h2>What --quality leaves</h2>\n" +
         html::table("",
                     {"garment", "preset", "nodes", "iterations", "wall, s", "processor, s",
                      "time ÷ standard's", "distance rms, mm", "largest, mm", "strain p99, points",
                      "ease, mm", "residual"},
                     lines);
}

std::string within_html(const Results& results) {
  std::vector<std::string> columns = {"scene", "method"};
  for (const double distance : asked_distances) columns.push_back(mm(distance, 1) + " mm");
  Lines lines;
  for (const MeshedScene& scene : meshed_scenes(results.rows)) {
    if (rows_of(results.rows, scene, "paper").empty()) continue;
    for (const char* method : {"relaxation", "paper"}) {
      const char* other = method == std::string("paper") ? "relaxation" : "paper";
      std::vector<Cell> line = {{scene.name + ", " + number(scene.edge_mm, 3) + " mm", ""},
                                {method, ""}};
      for (const double distance : asked_distances) {
        const auto mine = seconds_within(results.rows, scene, method, distance);
        const auto others = seconds_within(results.rows, scene, other, distance);
        const bool loses = others && (!mine || *mine > *others);
        line.push_back({mine ? seconds(*mine) : "never", loses ? "bad" : mine ? "good" : ""});
      }
      lines.push_back(line);
    }
  }
  return html::table(
      "Processor seconds of the cheapest run that ended within that distance (rms) "
      "of its own rest",
      columns, lines);
}

std::string losses_html(const Results& results) {
  std::string html = "<h2>Where each method loses</h2>\n" + within_html(results) + "<ul>";
  for (const std::string& loss : losses(results)) html += "<li>" + html_escaped(loss) + "</li>\n";
  return html + "</ul>\n";
}

struct Quantity {
  std::string name;
  std::function<double(const Row&)> of;
};

Json curves_of(const Results& results, const MeshedScene& scene, const Quantity& quantity) {
  constexpr std::array shapes = {"circle", "triangle", "rect", "crossRot", "rectRot"};
  Json curves = Json::array();
  for (const std::string method : {"relaxation", "paper"}) {
    std::vector<std::string> knobs;
    for (const Row* row : rows_of(results.rows, scene, method)) {
      if (std::find(knobs.begin(), knobs.end(), row->knob) == knobs.end()) {
        knobs.push_back(row->knob);
      }
    }
    for (std::size_t k = 0; k < knobs.size(); ++k) {
      Json points = Json::array();
      for (const Row* row : rows_of(results.rows, scene, method)) {
        const double y = quantity.of(*row);
        // No logarithm of nothing.
        if (row->knob != knobs[k] || !(y > 0)) continue;
        points.push_back({{"x", row->outcome.processor}, {"y", y}, {"of", row->value}});
      }
      std::sort(points.begin(), points.end(),
                [](const Json& a, const Json& b) { return a["x"] < b["x"]; });
      curves.push_back({{"name", method + ": " + knobs[k]},
                        {"points", points},
                        {"colour", method == "paper" ? "#a8501e" : "#20558a"},
                        {"shape", shapes[k % shapes.size()]},
                        {"dashes", k == 0 ? Json::array() : Json::array({4, 3})}});
    }
  }
  return curves;
}

std::string charts_html(const Results& results, Json& charts) {
  const std::vector<Quantity> quantities = {
      {"nodes' distance from rest, rms, mm", [](const Row& row) { return 1e3 * row.error.rms; }},
      {"strain p99, error in points", [](const Row& row) { return 1e2 * row.error.strain_p99; }},
      {"ease, mean error in mm", [](const Row& row) { return 1e3 * row.error.ease.value_or(0); }}};
  std::string html = "<h2>Error against time</h2>\n";
  for (const MeshedScene& scene : meshed_scenes(results.rows)) {
    const auto rows = rows_of(results.rows, scene, "");
    html += "<h3>" + html_escaped(scene.name) + ", edges of " + number(scene.edge_mm, 3) + " mm, " +
            std::to_string(rows.front()->nodes) + " nodes</h3>\n<div class=\"charts\">";
    for (const Quantity& quantity : quantities) {
      if (std::all_of(rows.begin(), rows.end(),
                      [&](const Row* row) { return !(quantity.of(*row) > 0); })) {
        continue;
      }
      html += "<div class=\"chart\"><canvas data-chart=\"" + std::to_string(charts.size()) +
              "\"></canvas></div>";
      charts.push_back({{"title", scene.name},
                        {"y", quantity.name},
                        {"curves", curves_of(results, scene, quantity)}});
    }
    html += "</div>\n";
  }
  return html;
}

std::string meshes_html(const Results& results) {
  Lines lines;
  for (const Row& row : results.rows) {
    if (row.knob != "reference") continue;
    const bool paper = row.method == "paper";
    const Row* usual = find_row(results.rows, {row.scene, row.edge_mm}, row.method,
                                paper ? "default" : "quality", paper ? "" : standard_quality.name);
    lines.push_back({{row.scene, ""},
                     {row.method, ""},
                     {number(row.edge_mm, 3), ""},
                     {std::to_string(row.nodes), ""},
                     {usual != nullptr ? seconds(usual->outcome.processor) : none, ""},
                     {usual != nullptr ? mm(usual->error.rms) : none, ""},
                     {percent(row.drape.strain_p99), ""},
                     {mm(row.drape.lowest, 1), ""},
                     {row.error.ease ? mm(row.drape.ease) : none, ""},
                     {row.models_apart ? mm(*row.models_apart, 1) : none, ""},
                     {number(row.outcome.residual.median, 2), ""},
                     end_cell(row.outcome)});
  }
  return "<h2>What the mesh changes, and what separates the models</h2>\n"
         "<p>The references: each method at rest on each mesh. Time and distance are those of its "
         "usual run there (<code>--quality standard</code>; <code>--method paper</code>). A drape "
         "is one of several a real garment could take, and a finer mesh can find another.</p>\n" +
         html::table("",
                     {"scene", "method", "edges, mm", "nodes", "usual run, processor s",
                      "its distance rms, mm", "strain p99, %", "lowest node, mm", "ease, mean, mm",
                      "models apart, rms, mm", "residual", "end"},
                     lines);
}

std::string terms_html(const Results& results) {
  Lines lines;
  const TermRow* all = nullptr;
  for (const TermRow& row : results.terms) {
    if (all == nullptr || all->scene != row.scene) all = &row;
    const bool whole = all == &row;
    const auto ratio = [&](double mine, double of_all) { return fixed_number(mine / of_all, 2); };
    const double per_iteration = row.outcome.processor / row.outcome.iterations;
    lines.push_back(
        {{row.scene, ""},
         {row.term, ""},
         {seconds(row.outcome.processor), ""},
         {ratio(row.outcome.processor, all->outcome.processor), ""},
         {std::to_string(row.outcome.iterations), ""},
         {ratio(per_iteration, all->outcome.processor / all->outcome.iterations), ""},
         {whole ? none : mm(row.error.rms, 1), ""},
         {whole ? none : mm(row.error.max, 1), ""},
         {whole ? none : percent(row.error.strain_p99), ""},
         {whole ? none : mm(row.error.ease.value_or(0)), ""},
         {std::to_string(row.body_intersections) + " / " + std::to_string(row.self_intersections),
          row.body_intersections + row.self_intersections > 0 ? "bad" : ""},
         end_cell(row.outcome)});
  }
  return "<h2>What each term costs, and what it buys</h2>\n"
         "<p>The same garment, dressed to <code>--quality fine</code> with all terms, and with one "
         "taken out (the strain limit: put in, for garments do without). Time against that with "
         "all terms; the differences are what the drape is wrong by without the term. The time of "
         "one iteration tells a term's cost apart from the way to rest that it changes. Edge "
         "contact is that of edges' middles with the body, and the bounds that keep triangles from "
         "meeting it; both need the body's exact surface and go together.</p>\n" +
         html::table("",
                     {"scene", "terms", "processor, s", "time ÷ all terms", "iterations",
                      "an iteration ÷ all terms", "distance rms, mm", "largest, mm",
                      "strain p99, points", "ease, mm", "intersections body / self", "end"},
                     lines);
}

std::string all_html(const Results& results) {
  Lines lines;
  for (const Row& row : results.rows) {
    const Outcome& run = row.outcome;
    lines.push_back({{row.scene + ", " + number(row.edge_mm, 3) + " mm", ""},
                     {row.method, ""},
                     {row.knob + " " + row.value, ""},
                     {seconds(run.wall), ""},
                     {seconds(run.processor), ""},
                     {std::to_string(run.iterations), ""},
                     {run.simulated > 0 ? fixed_number(run.simulated, 2) : none, ""},
                     {number(run.residual.median, 2), ""},
                     {mm(row.error.rms), ""},
                     {mm(row.error.max), ""},
                     {percent(row.error.strain_p99), ""},
                     {row.error.ease ? mm(*row.error.ease, 3) : none, ""},
                     {row.models_apart ? mm(*row.models_apart, 1) : none, ""},
                     end_cell(run)});
  }
  return "<h2>All runs</h2>\n" +
         html::table("",
                     {"scene", "method", "knob", "wall, s", "processor, s", "iterations",
                      "simulated, s", "residual", "distance rms, mm", "largest, mm",
                      "strain p99, points", "ease, mm", "models apart, rms, mm", "end"},
                     lines);
}

}  // namespace

std::string presets_table(const Results& results) {
  std::string text =
      "| garment | nodes | preset | iterations | processor time, standard = 1 | distance rms, "
      "largest | strain p99 error | ease error |\n|---|---|---|---|---|---|---|---|\n";
  for (const Preset& preset : presets(results)) {
    const Row& row = *preset.row;
    text += "| " + row.scene + " | " + std::to_string(row.nodes) + " | `" + row.value + "` | " +
            std::to_string(row.outcome.iterations) + " | " + fixed_number(preset.time_ratio, 2) +
            " | " + mm(row.error.rms) + ", " + mm(row.error.max, 1) + " mm | " +
            percent(row.error.strain_p99) + " points | " + mm(*row.error.ease, 3) + " mm |\n";
  }
  return text;
}

std::string expectations(const Results& results) {
  std::string text;
  for (const Quality& quality : qualities) {
    double largest = 0;
    for (const Preset& preset : presets(results)) {
      if (preset.row->value == quality.name) largest = std::max(largest, preset.row->error.rms);
    }
    text += std::string(quality.name) + ": " + mm(largest) + " mm measured, " +
            fixed_number(1000 * quality.distance_rms, 2) + " mm in cloth/dressing/quality.h\n";
  }
  return text;
}

std::string page_of(const Results& results) {
  Json charts = Json::array();
  std::string body = "<p>" + std::to_string(std::thread::hardware_concurrency()) +
                     " processors; load of the machine at the start " + html_escaped(results.load) +
                     ".</p>\n";
  if (!results.rows.empty()) {
    body += presets_html(results) + losses_html(results) + charts_html(results, charts) +
            meshes_html(results);
  }
  if (!results.terms.empty()) body += terms_html(results);
  if (!results.rows.empty()) body += all_html(results);
  return html::page("tests/benchmarks/work_precision/page.html", body, charts, TOILE_CHART_JS);
}

}  // namespace toile::precision
