#include "pattern/seams/sewn_file.h"

#include <nlohmann/json.hpp>

#include "io/json_value.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// The file's own stitch of the same two edges; null: there is none.
const Json* stitch_of(const Json& stitches, const Pattern& pattern, const FoundSeam& seam) {
  const auto is = [&](const Json& side, const EdgeRef& ref) {
    return side["panel"] == pattern.panels[ref.panel].name && side["edge"] == ref.edge;
  };
  for (const Json& stitch : stitches) {
    if ((is(stitch[0], seam.a) && is(stitch[1], seam.b)) ||
        (is(stitch[0], seam.b) && is(stitch[1], seam.a))) {
      return &stitch;
    }
  }
  return nullptr;
}

}  // namespace

int indent_of(const std::string& text) {
  const std::size_t line = text.find('\n', text.find('{'));
  if (line == std::string::npos) return -1;
  const std::size_t word = text.find_first_not_of(' ', line + 1);
  if (word == std::string::npos || word == line + 1) return 2;
  return static_cast<int>(std::min<std::size_t>(word - line - 1, 8));
}

bool has_drawn_walk(const std::string& text, const std::string& name) {
  const JsonDocument document(text, name);
  const auto properties = document.root().find("properties");
  if (!properties) return false;
  const auto loops = properties->find("normalized_edge_loops");
  return loops && loops->flag();
}

std::string with_stitches(const std::string& text, const Pattern& pattern,
                          const std::vector<FoundSeam>& seams, bool drawn_walk) {
  Json file = parse_json(text, pattern.source);
  Json stitches = Json::array();
  const Json drawn = file["pattern"].value("stitches", Json::array());
  for (const FoundSeam& seam : seams) {
    // A seam that was kept keeps its name, its gathers and its direction.
    if (const Json* own = seam.given ? stitch_of(drawn, pattern, seam) : nullptr) {
      stitches.push_back(*own);
      continue;
    }
    Json stitch = Json::array();
    for (const EdgeRef& side : {seam.a, seam.b}) {
      stitch.push_back({{"panel", pattern.panels[side.panel].name}, {"edge", side.edge}});
    }
    if (!seam.reversed) {
      stitch.push_back("right_wrong");
    } else if (!drawn_walk) {
      stitch.push_back({{"reversed", true}});
    }
    stitches.push_back(std::move(stitch));
  }
  file["pattern"]["stitches"] = std::move(stitches);
  return file.dump(indent_of(text)) + "\n";
}

}  // namespace toile
