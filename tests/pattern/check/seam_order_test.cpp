#include "pattern/check/seam_order.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"

namespace toile {
namespace seam_order_test {

using samples::file;
using samples::polygon;

std::string stitch(int a, int b) {
  return R"([{"panel": "a", "edge": )" + std::to_string(a) + R"(}, {"panel": "b", "edge": )" +
         std::to_string(b) + R"(}, {"reversed": false}])";
}

/// Two panels, one behind the other. Their right sides are cut into 2, 3 and 20 cm, and into 3, 20
/// and 2 cm, from below.
Pattern sides(const std::string& stitches, std::vector<Remark>& remarks) {
  return parse_pattern(
      file(polygon("a", "[0,0],[20,0],[20,2],[20,5],[20,25],[0,25]", R"("translation": [0,0,10])") +
               "," + polygon("b", "[0,0],[20,0],[20,3],[20,23],[20,25],[0,25]"),
           stitches),
      "test.json", remarks);
}

// GarmentCode pairs pieces of a side by length, where both sides are cut in three.
TEST(CrossedRows, AreSewnAsOneEdgeFromEndToEnd) {
  std::vector<Remark> remarks;
  const Pattern pattern =
      sides(stitch(3, 2) + "," + stitch(1, 3) + "," + stitch(2, 1) + "," + stitch(5, 5), remarks);
  ASSERT_EQ(pattern.stitches.size(), 2u);
  EXPECT_EQ(pattern.stitches[0].a.edge, 3);
  EXPECT_EQ(pattern.stitches[0].b.edge, 2);
  for (const auto& [panel, edge] : {std::pair(0, 3), std::pair(1, 2)}) {
    const EdgeCurve& side = pattern.panels[panel].edges[edge].curve;
    EXPECT_NEAR(side.length(), 0.25, 1e-12);
    EXPECT_NEAR((side.start() - Vec2(0.2, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((side.end() - Vec2(0.2, 0.25)).norm(), 0, 1e-12);
    EXPECT_EQ(pattern.panels[panel].outline.size(), 4u);
  }
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_TRUE(remarks[0].warning);
  EXPECT_EQ(remarks[0].text,
            "test.json: edges 1, 2, 3 of panel 'a' and edges 1, 2, 3 of panel 'b' are sewn to each "
            "other out of order; each row is sewn as one edge, as 3 to 2");
}

TEST(CrossedRows, InOrderStay) {
  std::vector<Remark> remarks;
  EXPECT_EQ(sides(stitch(1, 1) + "," + stitch(2, 2) + "," + stitch(3, 3), remarks).stitches.size(),
            3u);
  EXPECT_EQ(sides(stitch(5, 5) + "," + stitch(3, 3) + "," + stitch(1, 1), remarks).stitches.size(),
            3u);
  EXPECT_TRUE(remarks.empty());
}

}  // namespace seam_order_test
}  // namespace toile
