#include "pattern/seams/cut_edges.h"

#include <gtest/gtest.h>

#include "geometry/polygon.h"

namespace toile {
namespace cut_edges_test {

/// A panel 40 cm wide and 60 cm high, whose outline is walked against its second edge.
Pattern one_panel() {
  PatternPanel panel;
  panel.name = "front";
  panel.edges.push_back({EdgeCurve::line({0, 0}, {0.4, 0}), "hem"});
  panel.edges.push_back({EdgeCurve::line({0.4, 0.6}, {0.4, 0}), ""});
  panel.edges.push_back({EdgeCurve::quadratic({0.4, 0.6}, {0.2, 0.5}, {0, 0.6}), ""});
  panel.edges.push_back({EdgeCurve::line({0, 0.6}, {0, 0}), ""});
  panel.outline = {{0, true}, {1, false}, {2, true}, {3, true}};
  Pattern pattern;
  pattern.panels.push_back(panel);
  return pattern;
}

std::vector<Vec2> outline(const PatternPanel& panel) {
  std::vector<Vec2> points;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& curve = panel.edges[step.edge].curve;
    const EdgeCurve walked = step.forward ? curve : curve.reversed();
    const Vec2 before = points.empty() ? walked.start() : points.back();
    EXPECT_LT((walked.start() - before).norm(), 1e-9);
    const std::vector<Vec2> some = walked.sample(64);
    points.insert(points.end(), some.begin(), some.end());
  }
  EXPECT_LT((points.front() - points.back()).norm(), 1e-9) << "the outline is closed";
  return points;
}

TEST(CutEdges, PartsHaveTheirSharesAndTheOutlineItsShape) {
  const Pattern drawn = one_panel();
  const EdgeCuts cuts = {{{0, 1}, {{0.25, false}}}, {{0, 2}, {{0.3, true}, {0.8, false}}}};
  const CutPattern cut = with_cuts(drawn, cuts);
  const PatternPanel& panel = cut.pattern.panels[0];
  ASSERT_EQ(panel.edges.size(), 7u);
  ASSERT_EQ(cut.parts[0].size(), 7u);
  ASSERT_EQ(cut.splits.size(), 3u);
  for (std::size_t e = 0; e < panel.edges.size(); ++e) {
    const EdgePart& part = cut.parts[0][e];
    const double whole = drawn.panels[0].edges[part.edge].curve.length();
    EXPECT_NEAR(panel.edges[e].curve.length(), (part.to - part.from) * whole, 1e-9) << "edge " << e;
  }
  EXPECT_EQ(panel.edges[1].curve.start(), Vec2(0.4, 0.6)) << "the first part keeps the number";
  EXPECT_NEAR(signed_area(outline(panel)), signed_area(outline(drawn.panels[0])), 1e-5);
  ASSERT_EQ(panel.notches.size(), 1u);
  EXPECT_LT((panel.notches[0].at - drawn.panels[0].edges[2].curve.at(0.3)).norm(), 1e-9);
}

TEST(CutEdges, SeamsOfUncutEdgesMoveAndMakeWay) {
  Pattern drawn = one_panel();
  drawn.panels.push_back(drawn.panels[0]);
  const CutPattern whole = with_cuts(drawn, {});
  FoundSeams found;
  for (const int edge : {1, 2, 3}) {
    FoundSeam seam;
    seam.a = {0, edge};
    seam.b = {1, edge};
    found.seams.push_back(seam);
  }
  const CutPattern cut = with_cuts(drawn, {{{0, 2}, {{0.5, false}}}});
  const PanelPart half{0, {2, 0.5, 1}};
  const FoundSeams moved = moved_to(found, whole, cut, {{half, {1, {3, 0, 1}}}});
  ASSERT_EQ(moved.seams.size(), 2u) << "edge 2 is cut, and edge 3 is sewn to its half";
  EXPECT_EQ(moved.seams[0].a.edge, 1);
  EXPECT_EQ(moved.seams[1].a.edge, 4);
  EXPECT_EQ(moved.seams[1].b.edge, 3);
}

}  // namespace cut_edges_test
}  // namespace toile
