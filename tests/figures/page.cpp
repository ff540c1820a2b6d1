#include "tests/figures/page.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/error.h"
#include "io/output_file.h"
#include "io/text.h"
#include "tests/figures/sheet.h"
#include "tests/support/html.h"

namespace toile::figures {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;
using html::Cell;
using html::table;

constexpr double wrapped = 0.95;  // share of the directions around a bone

std::string escaped(const Json& text) { return html_escaped(text.get<std::string>()); }

constexpr const char* last_sheet = "limits";

/// The figure's number: fig9 comes before fig10.
int order_of(const fs::path& path) {
  const std::string stem = path.stem().string();
  return stem == last_sheet ? std::numeric_limits<int>::max() : std::atoi(stem.c_str() + 3);
}

bool is_sheet(const fs::path& path) {
  const std::string stem = path.stem().string();
  if (path.extension() != ".json") return false;
  return stem == last_sheet ||
         (stem.rfind("fig", 0) == 0 && stem.size() > 3 &&
          std::all_of(stem.begin() + 3, stem.end(), [](char c) { return c >= '0' && c <= '9'; }));
}

std::vector<Json> read_sheets(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_sheet(entry.path())) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end(),
            [](const fs::path& a, const fs::path& b) { return order_of(a) < order_of(b); });
  std::vector<Json> sheets;
  for (const fs::path& path : paths) {
    sheets.push_back(Json::parse(read_file(path), nullptr, false));
    if (!sheets.back().is_object()) {
      throw Error(path.string(), "is no JSON", "run its figure program again");
    }
  }
  if (sheets.empty()) {
    throw Error(folder.string(), "holds no figure's JSON", "run the figure programs first");
  }
  return sheets;
}

std::string fixed(const Json& value, int decimals) {
  return value.is_number() ? fixed_number(value.get<double>(), decimals) : "–";
}

Cell judged(const std::string& text, bool good) { return {text, good ? "good" : "bad"}; }

std::string comparisons(const std::vector<Json>& sheets) {
  std::vector<std::vector<Cell>> rows;
  for (const Json& sheet : sheets) {
    for (const Json& line : sheet["comparisons"]) {
      Cell verdict{"", ""};
      if (line.contains("holds")) {
        verdict = line["holds"].get<bool>() ? judged("held", true) : judged("not held", false);
      }
      rows.push_back({{sheet["name"], ""},
                      {line["what"], ""},
                      {line["paper"], ""},
                      {line["ours"], ""},
                      verdict});
    }
  }
  return table("", {"figure", "what", "paper's number", "ours", ""}, rows);
}

std::string wraps_of(const Json& row, bool& all) {
  std::string text;
  for (const Json& wrap : row["wraps"]) {
    const double fraction = wrap["fraction"];
    all = all && fraction >= wrapped;
    text += (text.empty() ? "" : ", ") + wrap["part"].get<std::string>() + " " +
            fixed_number(fraction, 2);
  }
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::vector<Cell> quality_row(const Json& row) {
  const bool wanted_open = row["wanted"] == "unsewable";
  const int open = row["seams_open"];
  const Json& met = row["intersections"];
  const int all_met = met["body"].get<int>() + met["self"].get<int>() + met["layers"].get<int>();
  bool wraps_all = true;
  const std::string wraps = wraps_of(row, wraps_all);
  const bool controlled = row["strain_control"] != "none";
  const double most = row["strain_off_seams"]["max"];
  const double limit = row["strain_off_seams"]["limit"];
  const auto percent = [](const Json& value) { return fixed_number(100 * value.get<double>(), 2); };
  return {
      {row["name"], ""},
      {row["strain_control"], ""},
      judged(std::to_string(open), (open > 0) == wanted_open),
      judged(std::to_string(met["body"].get<int>()) + " / " +
                 std::to_string(met["self"].get<int>()) + " / " +
                 std::to_string(met["layers"].get<int>()),
             all_met == 0),
      wanted_open ? Cell{wraps, ""} : judged(wraps, wraps_all),
      controlled ? judged(percent(most), most <= limit) : Cell{percent(most), ""},
      {percent(row["strain_off_seams"]["p99"]), ""},
      {fixed(row["area_percent"]["during"], 2) + " / " + fixed(row["area_percent"]["end"], 2), ""},
      {fixed(row["perimeter_percent"]["during"], 2) + " / " +
           fixed(row["perimeter_percent"]["end"], 2),
       ""},
      {fixed(row["residual"]["median"], 3) + " / " + fixed(row["residual"]["rms"], 2), ""},
      judged(row["verdict"], row["verdict"] == row["wanted"])};
}

std::vector<Cell> cost_row(const Json& row) {
  std::string stages;
  if (row.contains("stages")) {
    for (const Json& stage : row["stages"]) {
      if (stage["steps"].get<long>() == 0) continue;
      stages += (stages.empty() ? "" : ", ") + stage["name"].get<std::string>() + " " +
                std::to_string(stage["steps"].get<long>()) + " (" + fixed(stage["simulated_s"], 2) +
                " s)";
    }
  }
  return {{row["name"], ""},
          {row["strain_control"], ""},
          {fixed(row["edge_mm"], 0), ""},
          {std::to_string(row["nodes"].get<long>()), ""},
          {std::to_string(row["triangles"].get<long>()), ""},
          {fixed(row["time_step_us"], 1), ""},
          {row.contains("stable_step_us") ? fixed(row["stable_step_us"], 1) : "–", ""},
          {std::to_string(row["steps"].get<long>()), ""},
          {stages, ""},
          {fixed(row["simulated_s"], 2), ""},
          {fixed(row["ms_per_step"], 2), ""},
          {fixed(row["seconds"], 0), ""}};
}

/// Where the strain control does not hold its limit.
std::vector<std::vector<Cell>> strained_rows(const Json& row) {
  constexpr std::size_t max_places = 6;
  std::vector<std::vector<Cell>> rows;
  if (row["strain_control"] == "none") return rows;
  for (const Json& place : row["strained_places"]) {
    if (rows.size() == max_places) break;
    rows.push_back({{row["name"], ""},
                    {place["panel"], ""},
                    {place["joint"], ""},
                    {fixed_number(place["height_m"].get<double>(), 2), ""},
                    {std::to_string(place["edges"].get<int>()), ""},
                    {fixed_number(100 * place["largest"].get<double>(), 2), ""},
                    {place["longer"].get<bool>() ? "stretched" : "crushed", ""}});
  }
  return rows;
}

std::string garments(const std::vector<Json>& sheets) {
  std::vector<std::vector<Cell>> quality;
  std::vector<std::vector<Cell>> cost;
  std::vector<std::vector<Cell>> strained;
  for (const Json& sheet : sheets) {
    for (const Json& row : sheet["garments"]) {
      quality.push_back(quality_row(row));
      cost.push_back(cost_row(row));
      for (auto& line : strained_rows(row)) strained.push_back(std::move(line));
    }
  }
  return "<h2>Garments</h2>\n" +
         table("What came out",
               {"garment", "strain control", "seams open", "intersections body / self / layers",
                "wraps (share)", "strain off seams, largest %", "99 %", "area %, way / end",
                "perimeter %, way / end", "residual, median / rms", "verdict"},
               quality) +
         "<p>Intersections are pairs of triangles that meet, with exact predicates. A part is "
         "wrapped when 95 % of the directions around its bones meet the garment. Strain is "
         "|length / rest − 1| of mesh edges that are not on a seam. Area and perimeter: largest "
         "change of any panel against the flat pattern. Residual: force left on a node, in mean "
         "node weights.</p>\n" +
         table("Where edges off the seams are beyond the limit",
               {"garment", "panel", "nearest joint", "height, m", "edges", "largest, %", ""},
               strained) +
         "<h2>Times and limits</h2>\n" +
         table("What it cost",
               {"garment", "strain control", "edges, mm", "nodes", "triangles", "step, µs",
                "largest stable step, µs", "steps", "by stage", "seconds simulated", "ms a step",
                "seconds"},
               cost) +
         "<p>The largest stable step is that of symplectic Euler on the springs without contact, "
         "from the bound of their stiffness over the masses. Seconds are those of the computer "
         "that made this page, from positioning to verdict.</p>\n";
}

std::string block_html(const Json& block, const fs::path& folder, Json& charts) {
  std::string html;
  if (block.contains("text")) return "<p>" + escaped(block["text"]) + "</p>\n";
  if (block.contains("pictures")) {
    html = "<h3>" + escaped(block["heading"]) + "</h3>\n<div class=\"" +
           (block["pictures"].size() == 1 ? "strip alone" : "strip") + "\">";
    for (const Json& picture : block["pictures"]) {
      const std::string png = read_file(folder / picture["file"].get<std::string>());
      html += "<figure><img alt=\"" + escaped(picture["caption"]) +
              "\" src=\"data:image/png;base64," + base64(png) + "\"><figcaption>" +
              escaped(picture["caption"]) + "</figcaption></figure>";
    }
    return html + "</div>\n";
  }
  if (block.contains("chart")) {
    html = "<div class=\"chart\"><canvas data-chart=\"" + std::to_string(charts.size()) +
           "\"></canvas></div>\n";
    charts.push_back(block["chart"]);
    return html;
  }
  const Json& t = block["table"];
  std::vector<std::vector<Cell>> rows;
  for (const Json& line : t["rows"]) {
    rows.emplace_back();
    for (const Json& cell : line) rows.back().push_back({cell, ""});
  }
  return table(t["caption"], t["columns"], rows);
}

}  // namespace

std::string figures_page(const fs::path& folder) {
  const std::vector<Json> sheets = read_sheets(folder);
  Json charts = Json::array();
  std::string body = comparisons(sheets) + garments(sheets);
  for (const Json& sheet : sheets) {
    body +=
        "<section id=\"" + escaped(sheet["name"]) + "\"><h2>" + escaped(sheet["title"]) + "</h2>\n";
    for (const Json& block : sheet["blocks"]) body += block_html(block, folder, charts);
    body += "</section>\n";
  }
  return html::page("tests/figures/page.html", body, charts, TOILE_CHART_JS);
}

}  // namespace toile::figures
