#include "pattern/seams/spare_panels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "tests/support/seam_comparison.h"

namespace toile {
namespace spare_panels_test {

using Json = nlohmann::ordered_json;

std::set<std::string> spare_of(const std::string& text, const std::string& name) {
  std::vector<Remark> remarks;
  const Pattern pattern = stripped(parse_drawn_pattern(text, name, remarks), true, false);
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(text, name);
  std::set<std::string> names;
  for (const int panel : spare_panels(pattern, options, find_seams(pattern, options))) {
    names.insert(pattern.panels[panel].name);
  }
  return names;
}

TEST(SparePanels, SamplesHaveNone) {
  for (const auto& entry : std::filesystem::directory_iterator(TOILE_SOURCE_DIR "/samples")) {
    if (entry.path().extension() != ".json") continue;
    const std::string name = entry.path().string();
    EXPECT_TRUE(spare_of(read_file(entry.path()), name).empty()) << name;
  }
}

TEST(SparePanels, LongSleevesBesideShortOnesHaveOnePairTooMany) {
  const std::string name = TOILE_SOURCE_DIR "/samples/tshirt.json";
  Json file = Json::parse(read_file(name));
  Json& panels = file["pattern"]["panels"];
  std::set<std::string> shorts;
  std::set<std::string> longs;
  for (const std::string side : {"left", "right"}) {
    for (const std::string face : {"f", "b"}) {
      const std::string sleeve = side + "_sleeve_" + face;
      Json panel = panels[sleeve];
      for (Json& vertex : panel["vertices"]) {
        if (std::abs(vertex[0].get<double>()) != 22) continue;
        vertex[0] = side == "left" ? 60 : -60;
        vertex[1] = 0.6 * vertex[1].get<double>();  // narrow at the wrist
      }
      const std::string longer = side + "_long_sleeve_" + face;
      panels[longer] = panel;
      if (file["pattern"].contains("panel_order")) {
        file["pattern"]["panel_order"].push_back(longer);
      }
      shorts.insert(sleeve);
      longs.insert(longer);
    }
  }
  const std::set<std::string> spare = spare_of(file.dump(), name);
  EXPECT_TRUE(spare == shorts || spare == longs) << ::testing::PrintToString(spare);
}

}  // namespace spare_panels_test
}  // namespace toile
