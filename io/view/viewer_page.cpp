#include "io/view/viewer_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <string_view>

#include "io/bytes.h"
#include "io/text.h"
#include "io/view/embedded.h"
#include "io/view/page_template.h"
#include "io/view/three.h"

TOILE_EMBED(toile_viewer_html, TOILE_VIEWER_PAGE);
TOILE_EMBED(toile_viewer_css, TOILE_VIEWER_STYLE);
TOILE_EMBED(toile_words_js, TOILE_VIEWER_WORDS);
TOILE_EMBED(toile_surface_js, TOILE_VIEWER_SURFACE);
TOILE_EMBED(toile_stage_js, TOILE_VIEWER_STAGE);
TOILE_EMBED(toile_section_js, TOILE_VIEWER_SECTION);
TOILE_EMBED(toile_viewer_js, TOILE_VIEWER);
TOILE_EMBED(toile_german_json, TOILE_GERMAN);
TOILE_EMBED(toile_french_json, TOILE_FRENCH);

namespace toile {

namespace {

using nlohmann::json;

json bytes_of(const Colour& colour) {
  const auto byte = [](double channel) { return std::lround(255 * std::clamp(channel, 0.0, 1.0)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

/// Coordinates as 32-bit floats.
template <typename Points>
std::string floats_of(const Points& points) {
  std::string bytes;
  for (const auto& point : points) {
    for (Eigen::Index k = 0; k < point.size(); ++k) store(bytes, static_cast<float>(point[k]));
  }
  return base64(bytes);
}

std::string floats_of(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) store(bytes, static_cast<float>(value));
  return base64(bytes);
}

std::string indices_of(const std::vector<int>& indices) {
  std::string bytes;
  for (const int index : indices) store(bytes, static_cast<std::uint32_t>(index));
  return base64(bytes);
}

std::string indices_of(const std::vector<Triangle>& triangles) {
  std::string bytes;
  for (const Triangle& triangle : triangles) {
    for (const int corner : triangle) store(bytes, static_cast<std::uint32_t>(corner));
  }
  return base64(bytes);
}

/// The surface: its triangles so that those of a region follow one another.
json surface_json(const ViewerPage& page, json& regions) {
  std::vector<std::size_t> order(page.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t t) { return page.region_of_triangle[t]; });
  std::vector<Triangle> sorted;
  std::vector<std::size_t> counts(page.regions.size(), 0);
  for (const std::size_t t : order) {
    sorted.push_back(page.triangles[t]);
    ++counts[static_cast<std::size_t>(page.region_of_triangle[t])];
  }
  std::size_t first = 0;
  for (std::size_t i = 0; i < page.regions.size(); ++i) {
    regions.push_back(
        {{"name", valid_utf8(page.regions[i])}, {"first", first}, {"count", counts[i]}});
    first += counts[i];
  }
  json surface = {{"nodes", floats_of(page.nodes)}, {"triangles", indices_of(sorted)}};
  if (!page.node_of.empty()) surface["nodeOf"] = indices_of(page.node_of);
  if (!page.flat.empty()) {
    surface["flat"] = floats_of(page.flat);
    surface["pattern"] = floats_of(page.pattern);
  }
  return surface;
}

json map_json(const PageMap& map) {
  json result = {{"tab", map.tab},   {"name", map.name},         {"reading", map.reading},
                 {"unit", map.unit}, {"decimals", map.decimals}, {"values", floats_of(map.values)}};
  if (map.tab.empty()) return result;
  const ColourRamp& ramp = map.bar.ramp;
  result["title"] = map.bar.title;
  result["meaning"] = map.meaning;
  result["low"] = ramp.low;
  result["high"] = ramp.high;
  for (const Colour& step : ramp.steps) result["steps"].push_back(bytes_of(step));
  result["below"] = {{"colour", bytes_of(ramp.below)}, {"text", map.bar.below}};
  result["above"] = {{"colour", bytes_of(ramp.above.value_or(ramp.steps.back()))},
                     {"text", map.bar.above}};
  result["marks"] = json::array();
  for (const BarMark& mark : marks_of(map.bar)) result["marks"].push_back({mark.value, mark.text});
  return result;
}

json line_json(const PageLine& line) {
  std::vector<int> ends;
  std::vector<double> parts;
  for (const std::array<PagePlace, 2>& piece : line.pieces) {
    for (const PagePlace& place : piece) {
      ends.insert(ends.end(), {place.a, place.b});
      parts.push_back(place.part);
    }
  }
  json result = {{"ends", indices_of(ends)}, {"parts", floats_of(parts)}};
  if (line.normal != Vec3::Zero()) {
    result["origin"] = {line.origin.x(), line.origin.y(), line.origin.z()};
    result["normal"] = {line.normal.x(), line.normal.y(), line.normal.z()};
  }
  return result;
}

std::string data_of(const ViewerPage& page) {
  json data;
  data["regions"] = json::array();
  data["surface"] = surface_json(page, data["regions"]);
  for (const PageMap& map : page.maps) data["maps"].push_back(map_json(map));
  data["settings"] = json::array();
  for (const PageSetting& setting : page.settings) {
    data["settings"].push_back({{"name", valid_utf8(setting.name)},
                                {"points", floats_of(setting.mesh.points)},
                                {"triangles", indices_of(setting.mesh.triangles)}});
  }
  data["lines"] = json::array();
  for (const PageLine& line : page.lines) data["lines"].push_back(line_json(line));
  return json_in_html(data.dump());
}

std::string element(std::string_view open, const std::string& text, std::string_view close) {
  return std::string(open) + html_escaped(text) + std::string(close);
}

std::string table_of(const PageTable& table) {
  std::string html = "<section class=\"table\" data-sheet=\"" + std::to_string(table.sheet) + "\">";
  html += "<table>" + element("<caption>", table.caption, "</caption>\n<thead><tr>");
  for (const PageColumn& column : table.columns) {
    html += element("<th scope=\"col\">", column.name, "</th>");
  }
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto of_row = [&](const std::vector<int>& all) { return i < all.size() ? all[i] : -1; };
    const int region = of_row(table.regions);
    const int line = of_row(table.lines);
    const auto is = [&](const std::vector<bool>& all) { return i < all.size() && all[i]; };
    html += is(table.hurts)     ? "<tr class=\"hurts\""
            : is(table.quiet)   ? "<tr class=\"quiet\""
            : is(table.between) ? "<tr class=\"between\""
                                : "<tr";
    if (region >= 0) html += " data-region=\"" + std::to_string(region) + "\"";
    if (line >= 0) html += " data-line=\"" + std::to_string(line) + "\"";
    html += region >= 0 || line >= 0 ? " tabindex=\"0\">" : ">";
    for (std::size_t k = 0; k < table.rows[i].size(); ++k) {
      // The name of a region is a name, and not a word to translate.
      const std::string_view open = k == 0 && region >= 0        ? "<td translate=\"no\">"
                                    : k == 0                     ? "<td>"
                                    : table.columns[k].is_length ? "<td data-cm>"
                                                                 : "<td>";
      html += element(open, table.rows[i][k], "</td>");
    }
    html += "</tr>\n";
  }
  html += "</tbody></table>\n";
  if (!table.remark.empty()) {
    html += "<details class=\"remark\"><summary>How it is measured</summary>\n";
    std::istringstream remarks(table.remark);
    for (std::string line; std::getline(remarks, line);) html += element("<p>", line, "</p>\n");
    html += "</details>\n";
  }
  return html + "</section>\n";
}

std::string facts_of(const ViewerPage& page) {
  std::string html;
  for (const auto& [name, value] : page.facts) {
    html += element("<div><dt>", name, "</dt>") +
            element("<dd translate=\"no\">", value, "</dd></div>\n");
  }
  return html;
}

std::string verdict_of(const PageVerdict& verdict) {
  std::string html;
  if (!verdict.word.empty()) {
    const std::string_view tone = verdict.tone == PageVerdict::Tone::good   ? "good"
                                  : verdict.tone == PageVerdict::Tone::fair ? "fair"
                                                                            : "bad";
    html += element("<p class=\"verdict " + std::string(tone) + "\">", verdict.word, "</p>\n");
  }
  if (verdict.reasons.empty()) return html;
  html += "<ol class=\"reasons\">\n";
  for (const PageReason& reason : verdict.reasons) {
    const std::string line =
        reason.line < 0 ? ">"
                        : " data-line=\"" + std::to_string(reason.line) + "\" tabindex=\"0\">";
    html += element("<li" + line, reason.text, "</li>\n");
  }
  return html + "</ol>\n";
}

std::string warnings_of(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return "";
  std::string html = "<details class=\"warnings\" open><summary>Warnings</summary><ul>\n";
  for (const std::string& warning : warnings) html += element("<li>", warning, "</li>\n");
  return html + "</ul></details>\n";
}

}  // namespace

std::string viewer_page(const ViewerPage& page) {
  const auto content = [&](std::string_view name) -> std::string {
    if (name == "title") return html_escaped(page.title);
    if (name == "style") return std::string(toile_viewer_css);
    if (name == "facts") return facts_of(page);
    if (name == "verdict") return verdict_of(page.verdict);
    if (name == "warnings") return warnings_of(page.warnings);
    if (name == "paragraphs") {
      std::string html;
      for (const std::string& text : page.paragraphs)
        html += element("<p class=\"soft\">", text, "</p>\n");
      return html;
    }
    if (name == "tables") {
      std::string html;
      for (const PageTable& table : page.tables) html += table_of(table);
      return html;
    }
    if (name == "still") {
      return page.still_png.empty() ? ""
                                    : "<img id=\"still\" alt=\"the surface from the front and the "
                                      "back\" src=\"data:image/png;base64," +
                                          base64(page.still_png) + "\">";
    }
    if (name == "data") return data_of(page);
    if (name == "languages") {
      return json_in_html("{\"de\":" + std::string(toile_german_json) +
                          ",\"fr\":" + std::string(toile_french_json) + "}");
    }
    if (name == "words") return std::string(toile_words_js);
    if (name == "surface") return std::string(toile_surface_js);
    if (name == "stage") return std::string(toile_stage_js);
    if (name == "section") return std::string(toile_section_js);
    if (name == "viewer") return std::string(toile_viewer_js);
    return three_js();  // "three"
  };
  return filled(toile_viewer_html, content);
}

}  // namespace toile
