#include "pattern/seams/shell_panels.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pattern/pattern_file.h"

namespace toile {
namespace shell_panels_test {

using Json = nlohmann::ordered_json;

Json piece(const Json& vertices) {
  Json edges = Json::array();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    edges.push_back({{"endpoints", {i, (i + 1) % vertices.size()}}});
  }
  return {{"vertices", vertices}, {"edges", edges}};
}

const Json band = piece({{0, 0}, {20, 0}, {20, 6}, {0, 6}});

std::string file_of(const Json& panels) {
  Json file;
  file["pattern"] = {{"panels", panels}, {"stitches", Json::array()}};
  for (const auto& [name, panel] : panels.items()) file["pattern"]["panel_order"].push_back(name);
  file["properties"] = {{"units_in_meter", 100}};
  return file.dump();
}

std::string left_out(const Json& panels) {
  std::vector<Remark> remarks;
  const Pattern pattern = parse_drawn_pattern(file_of(panels), "a.json", remarks);
  std::string text;
  for (const BesideShell& beside : panels_beside_shell(pattern)) {
    text += pattern.panels[beside.panel].name + " (" + beside.kind + ") ";
  }
  return text;
}

TEST(ShellPanels, APatternOfLiningsAloneIsAGarment) {
  EXPECT_EQ(left_out({{"front lining", band}, {"back lining", band}}), "");
  EXPECT_EQ(left_out({{"front", band}, {"back lining", band}}), "back lining (lining) ");
}

TEST(ShellPanels, AreTakenOutOfTheFileWithTheirStitches) {
  Json file = Json::parse(file_of({{"a", band}, {"b", band}, {"pocket", band}}));
  const auto side = [](const char* panel) { return Json{{"panel", panel}, {"edge", 0}}; };
  file["pattern"]["stitches"] = {{side("a"), side("b")}, {side("pocket"), side("a")}};
  Json other = Json::parse(without_panels(file.dump(), {"pocket"}));
  EXPECT_EQ(other["pattern"]["panel_order"], Json({"a", "b"}));
  EXPECT_EQ(other["pattern"]["stitches"].size(), 1u);
  EXPECT_FALSE(other["pattern"]["panels"].contains("pocket"));
  EXPECT_EQ(without_panels("as it is", {}), "as it is");
}

}  // namespace shell_panels_test
}  // namespace toile
