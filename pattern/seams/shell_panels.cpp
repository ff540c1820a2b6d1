#include "pattern/seams/shell_panels.h"

#include <nlohmann/json.hpp>

#include "io/json_value.h"
#include "pattern/seams/panel_words.h"
#include "pattern/seams/sewn_file.h"

namespace toile {

std::map<int, std::string> panels_beside_shell(const Pattern& pattern) {
  std::map<int, std::string> marked;
  std::map<int, std::string> beside;
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    if (!panel.left_out.empty()) marked[p] = panel.left_out;
    const std::string kind = panel.left_out.empty() ? kind_beside_shell(panel) : panel.left_out;
    if (!kind.empty()) beside[p] = kind;
  }
  return beside.size() == pattern.panels.size() ? marked : beside;
}

std::string with_left_out(const std::string& text, const std::string& name,
                          const std::map<std::string, std::string>& kinds) {
  using Json = nlohmann::ordered_json;
  Json file = parse_json(text, name);
  bool changed = false;
  for (auto& [called, panel] : file["pattern"]["panels"].items()) {
    const auto kind = kinds.find(called);
    if (kind == kinds.end()) {
      changed = panel.erase("left_out") > 0 || changed;
    } else if (panel.value("left_out", "") != kind->second) {
      panel["left_out"] = kind->second;
      changed = true;
    }
  }
  return changed ? file.dump(indent_of(text)) + "\n" : text;
}

}  // namespace toile
