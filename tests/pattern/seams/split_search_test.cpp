#include "pattern/seams/split_search.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/dxf.h"
#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/import/dxf_pieces.h"
#include "pattern/import/imported_pattern.h"
#include "pattern/seams/sewn_file.h"

namespace toile {
namespace split_search_test {

const std::filesystem::path source = TOILE_SOURCE_DIR;

SplitSeams found_in(const std::string& text, const std::string& name) {
  std::vector<Remark> remarks;
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(text, name);
  return find_split_seams(text, name, parse_drawn_pattern(text, name, remarks), options);
}

TEST(SplitSearch, ASleeveCapIsCutForFrontAndBack) {
  ImportOptions options;
  options.unfold = {"Detail_2", "Detail_3", "Detail_4"};
  options.pairs = {"Detail"};
  options.names = {"Detail=sleeve", "Detail_2=front", "Detail_3=back"};
  std::vector<Remark> remarks;
  const std::string drawing = read_file(source / "tests/io/drawings/halves.dxf");
  const std::string text = readable_json(pattern_json(
      import_pieces(dxf_pieces(parse_dxf(drawing, "a.dxf"), "a.dxf", {}), options, remarks)));
  const SplitSeams split = found_in(text, "a.json");
  ASSERT_EQ(split.splits.size(), 2u) << "each cap once";
  EXPECT_EQ(split.found.seams.size(), 15u);
  int caps = 0;
  for (const FoundSeam& seam : split.found.seams) {
    const std::string& a = split.pattern.panels[seam.a.panel].name;
    const std::string& b = split.pattern.panels[seam.b.panel].name;
    EXPECT_NEAR(seam.length_a / seam.length_b, 1, 0.02) << a << " " << b;
    if (a.find("sleeve") == std::string::npos || b.find("sleeve") != std::string::npos) continue;
    ++caps;
    EXPECT_TRUE(b == "front" || b == "back") << a << " " << b;
    // The cap's ends are low, as the armhole's are at the underarm: both sides rise together.
    const EdgeCurve& cap = split.pattern.panels[seam.a.panel].edges[seam.a.edge].curve;
    const EdgeCurve& hole = split.pattern.panels[seam.b.panel].edges[seam.b.edge].curve;
    const double rise = cap.end().y() - cap.start().y();
    const double other = hole.end().y() - hole.start().y();
    EXPECT_EQ(rise > 0, (other > 0) != seam.reversed) << a << " " << b;
  }
  EXPECT_EQ(caps, 4);
}

TEST(SplitSearch, WhereEachEdgeHasItsPartnerNoneIsCut) {
  const std::string name = (source / "samples/tshirt.json").string();
  const std::string text = read_file(name);
  const SplitSeams split = found_in(text, name);
  EXPECT_TRUE(split.splits.empty());
  EXPECT_EQ(split.text, text);
}

TEST(SplitSearch, ANotchOnOneSideAloneDoesNotEndAnEdge) {
  // A skirt. The front's sides are cut at a notch 25 cm above the hem, the back's are not.
  nlohmann::ordered_json front;
  front["vertices"] = {{-27, 0}, {27, 0}, {22, 25}, {19, 40}, {-19, 40}, {-22, 25}};
  for (int i = 0; i < 6; ++i) front["edges"].push_back({{"endpoints", {i, (i + 1) % 6}}});
  front["notches"] = {{{"vertex", 2}}, {{"vertex", 5}}};
  nlohmann::ordered_json back;
  back["vertices"] = {{-30, 0}, {30, 0}, {22, 40}, {-22, 40}};
  for (int i = 0; i < 4; ++i) back["edges"].push_back({{"endpoints", {i, (i + 1) % 4}}});
  nlohmann::ordered_json file;
  file["pattern"]["panels"] = {{"front", front}, {"back", back}};
  file["pattern"]["stitches"] = nlohmann::ordered_json::array();
  file["properties"] = {{"units_in_meter", 100}, {"normalized_edge_loops", true}};
  const SplitSeams split = found_in(file.dump(), "a.json");
  ASSERT_EQ(split.splits.size(), 2u);
  int lower = 0;
  for (const FoundSeam& seam : split.found.seams) {
    EXPECT_NE(seam.a.panel, seam.b.panel);
    EXPECT_NEAR(seam.length_a, seam.length_b, 1e-6);
    if (seam.length_a > 0.2) ++lower;
  }
  EXPECT_EQ(split.found.seams.size(), 4u);
  EXPECT_EQ(lower, 2) << "the longer parts meet";
}

}  // namespace split_search_test
}  // namespace toile
