// Pieces of the pages that figures and benchmarks write.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geometry/error.h"
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

}  // namespace toile::html
