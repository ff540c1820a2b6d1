// Pieces of the pages that figures and benchmarks write.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "io/output_file.h"
#include "io/text.h"

namespace toile::html {

struct Cell {
  std::string text;
  std::string mark;  ///< "good", "bad" or empty
};

/// Text is plain, and escaped here; the caption may be empty.
inline std::string table(const std::string& caption, const std::vector<std::string>& columns,
                         const std::vector<std::vector<Cell>>& rows) {
  std::string html = "<div class=\"wide\"><table>";
  if (!caption.empty()) html += "<caption>" + html_escaped(caption) + "</caption>";
  html += "<thead><tr>";
  for (const std::string& column : columns) html += "<th>" + html_escaped(column) + "</th>";
  html += "</tr></thead><tbody>";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const Cell& cell : row) {
      html += cell.mark.empty() ? "<td>" : "<td class=\"" + cell.mark + "\">";
      html += html_escaped(cell.text) + "</td>";
    }
    html += "</tr>";
  }
  return html + "</tbody></table></div>\n";
}

/// JSON fit to stand in a script element, which a "</script" in a name must not end.
inline std::string script_json(const nlohmann::ordered_json& json) {
  std::string data = json.dump();
  for (std::size_t at = 0; (at = data.find('<', at)) != std::string::npos;) {
    data.replace(at, 1, "\\u003c");
  }
  return data;
}

/// Puts `with` in the place of `mark` in a page's template. Throws Error when it lacks that.
inline void fill(std::string& page, const std::string& mark, const std::string& with) {
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) throw Error("page.html", "lacks " + mark, "");
  page.replace(at, mark.size(), with);
}

/// A page made from its template, a path in the source tree, with the common style. `charts` is the
/// data of its script, which draws with the library at `chart_js`. Throws Error when a file or a
/// mark is missing.
inline std::string page(const std::string& page_template, const std::string& body,
                        const nlohmann::ordered_json& charts,
                        const std::filesystem::path& chart_js) {
  const std::filesystem::path source = TOILE_SOURCE_DIR;
  std::string page = read_file(source / page_template);
  fill(page, "@STYLE@", read_file(source / "tests/support/page.css"));
  fill(page, "@BODY@", body);
  fill(page, "@CHARTS@", script_json(charts));
  fill(page, "@CHART_JS@", read_file(chart_js));
  return page;
}

}  // namespace toile::html
