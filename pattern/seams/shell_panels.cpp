#include "pattern/seams/shell_panels.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pattern/seams/panel_words.h"
#include "pattern/seams/sewn_file.h"

namespace toile {

std::vector<BesideShell> panels_beside_shell(const Pattern& pattern) {
  std::vector<BesideShell> beside;
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    const std::string kind = kind_beside_shell(pattern.panels[p]);
    if (!kind.empty()) beside.push_back({p, kind});
  }
  if (beside.size() == pattern.panels.size()) beside.clear();
  return beside;
}

std::string without_panels(const std::string& text, const std::vector<std::string>& names) {
  if (names.empty()) return text;
  using Json = nlohmann::ordered_json;
  Json file = Json::parse(text);
  Json& pattern = file["pattern"];
  const auto is_left_out = [&](const Json& name) {
    return name.is_string() &&
           std::find(names.begin(), names.end(), name.get<std::string>()) != names.end();
  };
  const auto keep = [](const Json& list, const auto& is_out) {
    Json kept = Json::array();
    for (const Json& item : list) {
      if (!is_out(item)) kept.push_back(item);
    }
    return kept;
  };
  for (const std::string& name : names) pattern["panels"].erase(name);
  if (pattern.contains("panel_order")) {
    pattern["panel_order"] = keep(pattern["panel_order"], is_left_out);
  }
  if (pattern.contains("stitches")) {
    pattern["stitches"] = keep(pattern["stitches"], [&](const Json& stitch) {
      return is_left_out(stitch[0]["panel"]) || is_left_out(stitch[1]["panel"]);
    });
  }
  return file.dump(indent_of(text)) + "\n";
}

}  // namespace toile
