#include "io/view/viewer_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>

#include "io/bytes.h"
#include "io/text.h"
#include "io/view/embedded.h"
#include "io/view/page_template.h"
#include "io/view/three.h"

TOILE_EMBED(toile_viewer_page_html, TOILE_PAGE);

namespace toile {

namespace {

using nlohmann::json;

std::string hex(const Colour& colour) {
  static constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const double channel : {colour.red, colour.green, colour.blue}) {
    const auto byte = static_cast<unsigned>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
    text += digits[byte / 16];
    text += digits[byte % 16];
  }
  return text;
}

json bytes_of(const Colour& colour) {
  return {std::lround(255 * colour.red), std::lround(255 * colour.green),
          std::lround(255 * colour.blue)};
}

std::string points_text(const std::vector<Vec3>& points) {
  std::string bytes;
  for (const Vec3& point : points) {
    for (int k = 0; k < 3; ++k) store(bytes, static_cast<float>(point[k]));
  }
  return base64(bytes);
}

json mesh_data(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  const bool wide = points.size() > 65535;
  std::string bytes;
  for (const Triangle& triangle : triangles) {
    for (const int corner : triangle) {
      if (wide) {
        store(bytes, static_cast<std::uint32_t>(corner));
      } else {
        store(bytes, static_cast<std::uint16_t>(corner));
      }
    }
  }
  return {{"points", points_text(points)}, {"wide", wide}, {"triangles", base64(bytes)}};
}

std::string data_of(const ViewerPage& page) {
  // Sorts the triangles so that those of a region follow one another.
  std::vector<std::size_t> order(page.surface.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t t) { return page.region_of_triangle[t]; });
  std::vector<Triangle> sorted;
  std::vector<std::size_t> counts(page.regions.size(), 0);
  for (const std::size_t t : order) {
    sorted.push_back(page.surface.triangles[t]);
    ++counts[static_cast<std::size_t>(page.region_of_triangle[t])];
  }
  json regions = json::array();
  std::size_t first = 0;
  for (std::size_t i = 0; i < page.regions.size(); ++i) {
    regions.push_back(
        {{"name", valid_utf8(page.regions[i])}, {"first", first}, {"count", counts[i]}});
    first += counts[i];
  }
  std::string values;
  for (const double value : page.values) store(values, static_cast<float>(value));

  json data;
  data["surface"] = mesh_data(page.surface.points, sorted);
  data["surface"]["values"] = base64(values);
  data["setting"] = mesh_data(page.setting.points, page.setting.triangles);
  data["setting"]["name"] = valid_utf8(page.setting_name);
  data["regions"] = std::move(regions);
  data["unit"] = valid_utf8(page.unit);
  data["low"] = page.ramp.low;
  data["high"] = page.ramp.high;
  data["below"] = bytes_of(page.ramp.below);
  for (const Colour& step : page.ramp.steps) data["steps"].push_back(bytes_of(step));
  return json_in_html(data.dump());
}

std::string bar_of(const ViewerPage& page) {
  std::string stops;
  for (std::size_t i = 0; i < page.ramp.steps.size(); ++i) {
    stops += (i == 0 ? "" : ", ") + hex(page.ramp.steps[i]);
  }
  std::string html = "<div class=\"bar\"><div class=\"name\">" + html_escaped(page.quantity) +
                     ", " + html_escaped(page.unit) + "</div>\n<div class=\"row\">";
  if (!page.below.empty()) {
    html += "<div class=\"below\"><i style=\"background: " + hex(page.ramp.below) + "\"></i>" +
            html_escaped(page.below) + "</div>";
  }
  html +=
      "<div class=\"scale\"><div class=\"colours\" style=\"background: linear-gradient(to right, " +
      stops + ")\"></div><div class=\"ticks\">";
  const std::vector<double> ticks = round_ticks(page.ramp.low, page.ramp.high, 7);
  const int decimals = tick_decimals(ticks);
  for (const double tick : ticks) {
    const double place = 100 * (tick - page.ramp.low) / (page.ramp.high - page.ramp.low);
    html += "<span style=\"left: " + fixed_number(place, 2) + "%\">" +
            fixed_number(tick, decimals) + "</span>";
  }
  return html + "</div></div></div></div>";
}

std::string table_of(const PageTable& table) {
  std::string html = "<table><caption>" + html_escaped(table.caption) + "</caption>\n<thead><tr>";
  for (const std::string& column : table.columns) {
    html += "<th scope=\"col\">" + html_escaped(column) + "</th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const int region = i < table.regions.size() ? table.regions[i] : -1;
    html += region >= 0 ? "<tr data-region=\"" + std::to_string(region) + "\">" : "<tr>";
    for (const std::string& cell : table.rows[i]) html += "<td>" + html_escaped(cell) + "</td>";
    html += "</tr>\n";
  }
  html += "</tbody></table>\n";
  if (!table.remark.empty()) html += "<p class=\"remark\">" + html_escaped(table.remark) + "</p>\n";
  return html;
}

}  // namespace

std::string viewer_page(const ViewerPage& page) {
  std::string paragraphs;
  for (const std::string& paragraph : page.paragraphs) {
    paragraphs += "<p class=\"soft\">" + html_escaped(paragraph) + "</p>\n";
  }
  std::string tables;
  for (const PageTable& table : page.tables) tables += table_of(table);
  const std::string still = page.still_png.empty()
                                ? ""
                                : "<img alt=\"the coloured surface from the front and the back\" "
                                  "src=\"data:image/png;base64," +
                                      base64(page.still_png) + "\">";
  const auto content = [&](std::string_view name) -> std::string {
    if (name == "title") return html_escaped(page.title);
    if (name == "setting-name") return html_escaped(page.setting_name);
    if (name == "paragraphs") return paragraphs;
    if (name == "bar") return bar_of(page);
    if (name == "tables") return tables;
    if (name == "still") return still;
    if (name == "still-follows") return still.empty() ? "" : "; here it is from two sides";
    if (name == "data") return data_of(page);
    return three_js();  // "three"
  };
  return filled(toile_viewer_page_html, content);
}

}  // namespace toile
