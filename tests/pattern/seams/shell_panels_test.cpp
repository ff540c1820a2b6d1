#include "pattern/seams/shell_panels.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pattern/file/pattern_file.h"

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

std::string beside(const Json& panels) {
  std::vector<Remark> remarks;
  const Pattern pattern = parse_drawn_pattern(file_of(panels), "a.json", remarks);
  std::string text;
  for (const auto& [panel, kind] : panels_beside_shell(pattern)) {
    text += pattern.panels[panel].name + " (" + kind + ") ";
  }
  return text;
}

Json marked(const char* kind) {
  Json panel = band;
  panel["left_out"] = kind;
  return panel;
}

TEST(ShellPanels, APatternOfLiningsAloneIsAGarment) {
  EXPECT_EQ(beside({{"front lining", band}, {"back lining", band}}), "");
  EXPECT_EQ(beside({{"front", band}, {"back lining", band}}), "back lining (lining) ");
}

TEST(ShellPanels, WhatThePatternLeavesOutIsBesideWhateverItsName) {
  EXPECT_EQ(beside({{"front", band}, {"back", marked("inner layer")}, {"pocket", marked("patch")}}),
            "back (inner layer) pocket (patch) ");
  EXPECT_EQ(beside({{"pocket", band}, {"back", marked("inner layer")}}), "back (inner layer) ");
}

TEST(ShellPanels, AreMarkedInTheFileAndNothingElseChanges) {
  const std::string text = file_of({{"a", band}, {"b", marked("lining")}, {"pocket", band}});
  Json other = Json::parse(with_left_out(text, "a.json", {{"pocket", "pocket"}}));
  EXPECT_EQ(other["pattern"]["panels"]["pocket"]["left_out"], "pocket");
  EXPECT_FALSE(other["pattern"]["panels"]["b"].contains("left_out"));
  other["pattern"]["panels"]["pocket"].erase("left_out");
  other["pattern"]["panels"]["b"]["left_out"] = "lining";
  EXPECT_EQ(other.dump(), text);
  EXPECT_EQ(with_left_out(text, "a.json", {{"b", "lining"}}), text);
}

}  // namespace shell_panels_test
}  // namespace toile
