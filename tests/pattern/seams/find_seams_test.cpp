#include "pattern/seams/find_seams.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/output_file.h"
#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/sewn_file.h"
#include "pattern/seams/shell_panels.h"
#include "tests/pattern/samples.h"
#include "tests/support/seam_comparison.h"

namespace toile {
namespace find_seams_test {

// Bounds at what was reached: 0.93 and 0.96 with names, the same whatever the confidence.
// bench_seams_found has the whole table.
TEST(FindSeamsOfSamples, MostAreFoundAgainWithNames) {
  SeamMatches sum;
  SeamMatches all;
  for (const auto& entry : std::filesystem::directory_iterator(TOILE_SOURCE_DIR "/samples")) {
    if (entry.path().extension() != ".json") continue;
    std::vector<Remark> remarks;
    const std::string name = entry.path().string();
    const std::string text = read_file(entry.path());
    const Pattern pattern = parse_drawn_pattern(text, name, remarks);
    FindSeamsOptions options;
    options.drawn_walk = has_drawn_walk(text, name);
    std::set<SeamPair> decided;
    std::set<SeamPair> listed;
    for (const FoundSeam& seam : find_seams(stripped(pattern, true, false), options).seams) {
      listed.insert(seam_pair(seam.a, seam.b, seam.reversed));
      if (seam.confidence >= decided_confidence) {
        decided.insert(seam_pair(seam.a, seam.b, seam.reversed));
      }
    }
    SeamComparison comparison(pattern, options.drawn_walk, false);
    const SeamMatches figures = comparison.compare(stated_seams(pattern), decided);
    sum.stated += figures.stated;
    sum.found += figures.found;
    sum.right += figures.right;
    const SeamMatches of_all = comparison.compare(stated_seams(pattern), listed);
    all.found += of_all.found;
    all.right += of_all.right;
  }
  EXPECT_GE(sum.right, 0.925 * sum.found);
  EXPECT_GE(sum.right, 0.955 * sum.stated);
  EXPECT_GE(all.right, 0.925 * all.found);
  EXPECT_GE(all.right, 0.955 * sum.stated);
}

TEST(FindSeamsOfDrafts, TheMiddleOfAHoodIsSewnToBothSidesAndTheFaceStaysOpen) {
  const std::string name = TOILE_SOURCE_DIR "/tests/pattern/seams/drafts/hugo.json";
  const std::string text = read_file(name);
  std::vector<Remark> remarks;
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(text, name);
  options.certain = false;
  Pattern whole = parse_drawn_pattern(text, name, remarks);
  const std::map<int, std::string> beside = panels_beside_shell(whole);
  EXPECT_EQ(beside.size(), 5u) << "pockets, their facings and a binding";
  for (const auto& [panel, kind] : beside) whole.panels[panel].left_out = kind;
  const Pattern pattern = without_left_out(whole, remarks);
  std::set<std::string> of_middle;
  for (const FoundSeam& seam : find_seams(stripped(pattern, true, false), options).seams) {
    const std::string& a = pattern.panels[seam.a.panel].name;
    const std::string& b = pattern.panels[seam.b.panel].name;
    EXPECT_FALSE(a == "left_hoodSide" && b == "right_hoodSide" && seam.length_a > 0.2);
    if (a == "hoodCenter") of_middle.insert(b);
    if (b == "hoodCenter") of_middle.insert(a);
  }
  EXPECT_EQ(of_middle, (std::set<std::string>{"left_hoodSide", "right_hoodSide"}));
}

// The judge of these tests and of the bench.

// Two equal godets, each in a slit of its own.
Pattern skirt(const std::string& first, const std::string& second) {
  const std::string triangle = "[0,0],[10,0],[5,30]";
  std::vector<Remark> remarks;
  return parse_drawn_pattern(
      samples::file(samples::polygon("skirt",
                                     "[0,0],[20,0],[22,29.6],[24,0],[50,0],[52,29.6],[54,0],[90,0],"
                                     "[90,60],[0,60]") +
                    "," + samples::polygon(first, triangle) + "," +
                    samples::polygon(second, triangle)),
      "test", remarks);
}

/// The godets' panels in the two slits.
std::set<SeamPair> sewn(int first, int second) {
  std::set<SeamPair> seams;
  for (const auto& [godet, edge] : {std::pair{first, 1}, std::pair{second, 4}}) {
    seams.insert(seam_pair({0, edge}, {godet, 2}, true));
    seams.insert(seam_pair({0, edge + 1}, {godet, 1}, true));
  }
  return seams;
}

TEST(FindSeamsThatAreGiven, ALayeredPanelIsSewnByItsStitchesAlone) {
  const std::string square = "[0,0],[30,0],[30,50],[0,50]";
  Pattern pattern = samples::parse(samples::file(
      samples::polygon("skirt_front", square) + "," + samples::polygon("skirt_back", square) + "," +
          samples::polygon("facing", square),
      R"([{"panel":"skirt_front","edge":1},{"panel":"skirt_back","edge":3}],
         [{"panel":"skirt_front","edge":1},{"panel":"facing","edge":1},{"layer":true}])"));
  FindSeamsOptions options;
  options.given = pattern.stitches;
  const FoundSeams found = find_seams(pattern, options);
  int of_facing = 0;
  for (const FoundSeam& seam : found.seams) {
    if (seam.a.panel != 2 && seam.b.panel != 2) continue;
    ++of_facing;
    EXPECT_TRUE(seam.given);
    EXPECT_FALSE(seam.reversed);
  }
  EXPECT_EQ(of_facing, 1);
}

TEST(SeamComparisonOfNames, PiecesThatDifferInTheNumberAloneMayChangePlaces) {
  SeamComparison comparison(skirt("godet_0", "godet_1"), false, false);
  EXPECT_EQ(comparison.compare(sewn(1, 2), sewn(1, 2)).right, 4);
  EXPECT_EQ(comparison.compare(sewn(1, 2), sewn(2, 1)).right, 4);
  // One godet over both slits is another garment.
  std::set<SeamPair> across = sewn(1, 2);
  across.erase(seam_pair({0, 2}, {1, 1}, true));
  across.insert(seam_pair({0, 5}, {1, 1}, true));
  across.erase(seam_pair({0, 5}, {2, 1}, true));
  across.insert(seam_pair({0, 2}, {2, 1}, true));
  EXPECT_LT(comparison.compare(sewn(1, 2), across).right, 4);
}

TEST(SeamComparisonOfNames, FrontAndBackMayNot) {
  SeamComparison comparison(skirt("front_godet", "back_godet"), false, false);
  EXPECT_EQ(comparison.compare(sewn(1, 2), sewn(2, 1)).right, 0);
}

}  // namespace find_seams_test
}  // namespace toile
