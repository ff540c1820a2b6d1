#include "pattern/seams/walked_edges.h"

#include "pattern/seams/seam_pairs.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace walked_edges_test {

Pattern pattern_of(const std::string& panels) {
  std::vector<Remark> remarks;
  return parse_drawn_pattern(samples::file(panels), "test", remarks);
}

TEST(WalkedEdges, APanelTurnedOverIsWalkedTheOtherWayRound) {
  const Pattern pattern = pattern_of(samples::polygon("a", "[0,0],[30,0],[20,10],[0,10]"));
  for (const bool drawn_walk : {false, true}) {
    const auto plain = walked_edges(pattern, drawn_walk);
    const auto turned = walked_edges(pattern, drawn_walk, {1});
    ASSERT_EQ(plain.size(), turned.size());
    for (const WalkedEdge& edge : turned) {
      const auto same = std::find_if(plain.begin(), plain.end(), [&](const WalkedEdge& other) {
        return other.ref.edge == edge.ref.edge;
      });
      EXPECT_NE(edge.forward, same->forward);
      EXPECT_NEAR(edge.length, same->length, 1e-12);
      EXPECT_NEAR(edge.rise, -same->rise, 1e-12);
      EXPECT_NEAR(edge.upwards, same->upwards, 1e-12);
      // Its start is where the other walk ends.
      EXPECT_NEAR(edge.corner, plain[same->next].corner, 1e-12);
      EXPECT_EQ(plain[same->next].ref.edge, turned[edge.previous].ref.edge);
    }
  }
}

}  // namespace walked_edges_test
}  // namespace toile
