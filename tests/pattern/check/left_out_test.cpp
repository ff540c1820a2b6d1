#include "pattern/check/left_out.h"

#include <gtest/gtest.h>

#include "geometry/error.h"

namespace toile {
namespace left_out_test {

Pattern of(const std::vector<std::pair<std::string, std::string>>& panels) {
  Pattern pattern;
  pattern.source = "a.json";
  for (const auto& [name, left_out] : panels) {
    PatternPanel panel;
    panel.name = name;
    panel.left_out = left_out;
    pattern.panels.push_back(std::move(panel));
  }
  return pattern;
}

TEST(LeftOut, StitchesNameThePanelsThatStay) {
  Pattern pattern = of({{"pocket", "pocket"}, {"front", ""}, {"lining", "lining"}, {"back", ""}});
  pattern.stitches = {{"", {1, 0}, {3, 2}}, {"", {0, 1}, {1, 1}}};
  std::vector<Remark> remarks;
  const Pattern kept = without_left_out(pattern, remarks);
  ASSERT_EQ(kept.panels.size(), 2u);
  EXPECT_EQ(kept.panels[1].name, "back");
  ASSERT_EQ(kept.stitches.size(), 1u);
  EXPECT_EQ(kept.stitches[0].a.panel, 0);
  EXPECT_EQ(kept.stitches[0].b.panel, 1);
  EXPECT_EQ(kept.stitches[0].b.edge, 2);
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0].text, "a.json: left out: pocket (pocket), lining (lining)");
  EXPECT_FALSE(remarks[0].warning);
  EXPECT_EQ(remarks[1].text, "a.json: 1 stitch holds a panel that is left out; it is not sewn");
  EXPECT_TRUE(remarks[1].warning);
}

TEST(LeftOut, APatternThatLeavesNothingOutIsAsItWas) {
  std::vector<Remark> remarks;
  EXPECT_EQ(without_left_out(of({{"front", ""}, {"back", ""}}), remarks).panels.size(), 2u);
  EXPECT_TRUE(remarks.empty());
}

TEST(LeftOut, APatternThatLeavesAllOutIsRefused) {
  std::vector<Remark> remarks;
  EXPECT_THROW(without_left_out(of({{"pocket", "pocket"}}), remarks), Error);
}

}  // namespace left_out_test
}  // namespace toile
