#include "pattern/seams/shell_panels.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pattern/seams/panel_symmetry.h"
#include "pattern/seams/sewn_file.h"

namespace toile {

namespace {

/// The right one of each pair whose panels are the same full-width piece.
std::vector<int> inner_layers(const Pattern& pattern, bool drawn_walk) {
  std::vector<PanelWords> words;
  bool any = false;
  for (const PatternPanel& panel : pattern.panels) {
    words.push_back(words_of(panel));
    const PanelRole role = words.back().role;
    any = any || (words.back().side < 0 && (role == PanelRole::yoke || role == PanelRole::collar ||
                                            role == PanelRole::hood));
  }
  std::vector<int> inner;
  if (!any) return inner;
  const std::vector<PanelFit> fits = panel_fits(walked_edges(pattern, drawn_walk));
  for (int p = 0; p < static_cast<int>(words.size()); ++p) {
    const PanelRole role = words[p].role;
    if (words[p].side >= 0) continue;
    const auto mirrors = std::count_if(fits.begin(), fits.end(), [&](const PanelFit& fit) {
      return fit.from == p && fit.to == p && fit.mirrored;
    });
    // A rectangle is its own image in two ways. Half a collar may be one, or a curved band with
    // four edges; half a hood is neither.
    const bool is_collar = role == PanelRole::collar && words[p].face == 0;
    const bool is_whole = role == PanelRole::hood
                              ? mirrors > 0
                              : mirrors == 1 && pattern.panels[p].edges.size() > 4 &&
                                    (role == PanelRole::yoke || is_collar);
    if (!is_whole) continue;
    const bool has_twin = std::any_of(fits.begin(), fits.end(), [&](const PanelFit& fit) {
      return fit.from == p && words[fit.to].side > 0 && words[fit.to].whole == words[p].whole;
    });
    if (has_twin) inner.push_back(p);
  }
  return inner;
}

}  // namespace

std::vector<BesideShell> panels_beside_shell(const Pattern& pattern, bool drawn_walk) {
  const std::vector<int> inner = inner_layers(pattern, drawn_walk);
  std::vector<BesideShell> beside;
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    std::string kind = kind_beside_shell(pattern.panels[p]);
    if (kind.empty() && std::find(inner.begin(), inner.end(), p) != inner.end()) {
      kind = "inner layer";
    }
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
