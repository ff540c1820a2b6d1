#include "tools/edit_seams/pattern_check.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "pattern/check/check_pattern.h"
#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/mesh/seam_orientation.h"
#include "tools/remarks.h"

namespace toile {

namespace {

constexpr const char* pattern_source = "pattern";

using Named = std::set<std::array<int, 2>>;  // panel and edge

/// The edges in a text: "panel 'front', edge 3", "panel 'front', edges 1, 2 and 'back', edge 0".
Named edges_in(const std::string& text, const Pattern& pattern) {
  Named edges;
  for (int p = 0; p < static_cast<int>(pattern.panels.size()); ++p) {
    const std::string before = "'" + pattern.panels[p].name + "', edge";
    for (std::size_t at = 0; (at = text.find(before, at)) != std::string::npos;) {
      at += before.size();
      if (at < text.size() && text[at] == 's') ++at;
      // Numbers of the list follow a blank each, all but the first a comma too.
      while (at + 1 < text.size() && text[at] == ' ' && std::isdigit(text[at + 1]) != 0) {
        int edge = 0;
        for (++at; at < text.size() && std::isdigit(text[at]) != 0 && edge < 100'000; ++at) {
          edge = 10 * edge + (text[at] - '0');
        }
        edges.insert({p, edge});
        if (at < text.size() && text[at] == ',') ++at;
      }
    }
  }
  return edges;
}

/// The stitches with so many sides among the edges.
std::vector<std::size_t> seams_of(const Named& edges, const Pattern& pattern, int sides) {
  std::vector<std::size_t> seams;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    int named = 0;
    for (const EdgeRef& side : {pattern.stitches[s].a, pattern.stitches[s].b}) {
      named += edges.contains({side.panel, side.edge}) ? 1 : 0;
    }
    if (named >= sides) seams.push_back(s);
  }
  return seams;
}

nlohmann::json warning_json(std::string text, const Pattern& drawn) {
  const std::string before = std::string(pattern_source) + ": ";
  if (text.starts_with(before)) text.erase(0, before.size());
  const Named edges = edges_in(text, drawn);
  std::vector<std::size_t> seams = seams_of(edges, drawn, 2);
  if (seams.empty()) seams = seams_of(edges, drawn, 1);
  std::vector<std::string> panels;
  for (const PatternPanel& panel : drawn.panels) {
    if (text.find("'" + panel.name + "'") != std::string::npos) panels.push_back(panel.name);
  }
  return {{"text", text}, {"seams", seams}, {"panels", panels}};
}

/// As mesh-pattern says them before it meshes; an error is the last.
std::vector<std::string> warnings_of(const std::string& text) {
  std::vector<Remark> remarks;
  std::string error;
  try {
    const Pattern pattern = without_left_out(parse_pattern(text, pattern_source, remarks), remarks);
    check_pattern(pattern, remarks);
    orient(pattern, remarks);
  } catch (const std::exception& problem) {
    error = problem.what();
  }
  std::vector<std::string> warnings = warnings_in(remarks);
  if (!error.empty()) warnings.push_back(error);
  return warnings;
}

/// Per stitch whether it is reversed; null where a panel is left out.
nlohmann::json directions_of(const Pattern& drawn) {
  std::vector<Remark> said_above;
  const auto is_left_out = [&](int panel) { return !drawn.panels[panel].left_out.empty(); };
  nlohmann::json directions = nlohmann::json::array();
  std::vector<bool> found;
  if (!std::ranges::all_of(drawn.panels, [](const auto& p) { return !p.left_out.empty(); })) {
    found = orient(without_left_out(drawn, said_above), said_above).reversed;
  }
  auto next = found.begin();
  for (const Stitch& stitch : drawn.stitches) {
    if (is_left_out(stitch.a.panel) || is_left_out(stitch.b.panel)) {
      directions.push_back(nullptr);
    } else {
      directions.push_back(bool(*next++));
    }
  }
  return directions;
}

}  // namespace

std::string pattern_check_json(const std::string& pattern) {
  std::vector<Remark> said_below;
  const Pattern drawn = parse_drawn_pattern(pattern, pattern_source, said_below);
  nlohmann::json warnings = nlohmann::json::array();
  for (const std::string& text : warnings_of(pattern)) {
    warnings.push_back(warning_json(text, drawn));
  }
  return nlohmann::json{{"warnings", warnings}, {"reversed", directions_of(drawn)}}.dump();
}

}  // namespace toile
