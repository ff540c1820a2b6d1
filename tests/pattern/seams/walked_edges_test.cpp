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

TEST(WalkedEdges, ASlitIsTold) {
  // A dart from above, and one from below that a skirt would have for walking.
  const Pattern pattern = pattern_of(samples::polygon(
      "skirt_front", "[0,0],[19,0],[20,20],[21,0],[40,0],[40,60],[21,60],[20,48],[19,60],[0,60]"));
  const SeamEvidence evidence = seam_evidence(pattern, false);
  const SeamPairs pairs(evidence, true);
  const auto legs = [&](int first) {
    int e = 0;
    while (evidence.edges[e].ref.edge != first) ++e;
    return pairs.measures(e, evidence.edges[e].next);
  };
  const SeamMeasures slit = legs(1);
  const SeamMeasures dart = legs(6);
  for (const SeamMeasures* measures : {&slit, &dart}) {
    EXPECT_EQ((*measures)[static_cast<int>(SeamMeasure::dart)], 1);
  }
  EXPECT_GT(slit[static_cast<int>(SeamMeasure::slit)], 0.9);
  EXPECT_EQ(dart[static_cast<int>(SeamMeasure::slit)], 0);
}

}  // namespace walked_edges_test
}  // namespace toile
