#include "pattern/import/repair_pattern.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"

namespace toile {
namespace repair_pattern_test {

using namespace samples;

const std::string square = "[0,0],[30,0],[30,40],[0,40]";
const std::string sides = R"([{"panel": "a", "edge": 1}, {"panel": "b", "edge": 3}])";
const std::string turned = R"([{"panel": "b", "edge": 3}, {"panel": "a", "edge": 1}])";

struct Repaired {
  std::string text;
  std::string remarks;
};

Repaired repair(const std::string& text) {
  std::vector<Remark> remarks;
  Repaired done{repaired_pattern(text, "net.json", remarks), ""};
  for (const Remark& remark : remarks) done.remarks += remark.text + "\n";
  return done;
}

TEST(RepairPattern, WhatIsWholeStaysByteForByte) {
  const std::string text = file(polygon("a", square) + "," + polygon("b", square), sides);
  const Repaired done = repair(text);
  EXPECT_EQ(done.text, text);
  EXPECT_EQ(done.remarks, "");
}

TEST(RepairPattern, AStitchIsSewnOnce) {
  const Repaired done =
      repair(file(polygon("a", square) + "," + polygon("b", square), sides + "," + turned));
  EXPECT_HOLDS(done.remarks, "stitch 1: sews the same edges as stitch 0");
  EXPECT_EQ(parse(done.text).stitches.size(), 1u);
}

TEST(RepairPattern, ANarrowGapIsClosedAndAWideOneIsNot) {
  const auto open_by = [](const std::string& x) {
    return file(R"("a": {"vertices": [[0,0],[30,0],[)" + x + R"(,0],[30,40],[0,40]], "edges": [
        {"endpoints": [0,1]}, {"endpoints": [2,3]}, {"endpoints": [3,4]}, {"endpoints": [4,0]}]})");
  };
  const Repaired done = repair(open_by("30.04"));
  EXPECT_HOLDS(done.remarks, "panel 'a', edge 1: a gap of 0.4 mm to edge 0 is closed");
  EXPECT_EQ(parse(done.text).panels[0].edges.size(), 4u);
  const std::string wide = open_by("31");
  EXPECT_EQ(repair(wide).text, wide);
  EXPECT_HOLDS(error_of([&] { parse(wide); }), "panel 'a', edge");
}

TEST(RepairPattern, AnEdgeWithoutLengthGoesAndTheOthersAreCountedAnew) {
  const Repaired done =
      repair(file(polygon("a", "[0,0],[30,0],[30,0],[30,40],[0,40]") + "," + polygon("b", square),
                  R"([{"panel": "a", "edge": 2}, {"panel": "b", "edge": 3}],
         [{"panel": "a", "edge": 1}, {"panel": "b", "edge": 0}])"));
  EXPECT_HOLDS(done.remarks, "panel 'a', edge 1: has no length");
  EXPECT_HOLDS(done.remarks, "stitch 1: sews an edge without length");
  const Pattern pattern = parse(done.text);
  EXPECT_EQ(pattern.panels[0].edges.size(), 4u);
  ASSERT_EQ(pattern.stitches.size(), 1u);
  EXPECT_EQ(pattern.stitches[0].a.edge, 1);
  EXPECT_NEAR(pattern.panels[0].edges[1].curve.length(), 0.4, 1e-12);
}

TEST(RepairPattern, OtherFormsAreLeftToTheReader) {
  for (const char* text :
       {"3", "{}", "[]", R"({"pattern": {"panels": 3}})", R"({"pattern": {"panels": {"a": 3}}})",
        R"({"pattern": {"panels": {"a": {"vertices": [], "edges": [{"endpoints": [0, 9]}]}}}})",
        R"({"pattern": {"panels": {}, "stitches": [[{"panel": "a"}]]}})"}) {
    EXPECT_EQ(repair(text).text, text);
  }
}

TEST(RepairPattern, TextThatIsNotJsonIsRefused) {
  EXPECT_HOLDS(error_of([] { repair("{"); }), "net.json:1:1: is not JSON here");
  EXPECT_HOLDS(error_of([] { repair(std::string(200000, '[')); }), "net.json:1:101: more than 100");
}

TEST(RepairPattern, AStitchToNoEdgeIsRefusedBeforeAnyRepair) {
  // Panel a has an edge without length.
  const std::string panels =
      polygon("a", "[0,0],[30,0],[30,0],[30,40],[0,40]") + "," + polygon("b", square);
  for (const char* edge : {"-1", "1e+10", "5"}) {
    const std::string text = file(panels, std::string(R"([{"panel": "a", "edge": )") + edge +
                                              R"(}, {"panel": "b", "edge": 3}])");
    EXPECT_HOLDS(error_of([&] { repair(text); }), std::string("net.json: stitch 0: names edge ") +
                                                      edge +
                                                      " of panel 'a', which has edges 0 to 4");
  }
}

}  // namespace repair_pattern_test
}  // namespace toile
