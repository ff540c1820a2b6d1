#include "pattern/seams/find_seams.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/output_file.h"
#include "pattern/left_out.h"
#include "pattern/pattern_file.h"
#include "pattern/seams/sewn_file.h"
#include "pattern/seams/shell_panels.h"
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

}  // namespace find_seams_test
}  // namespace toile
